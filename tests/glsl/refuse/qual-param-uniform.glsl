// May a parameter be `uniform float`?
void g(uniform float x) { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
