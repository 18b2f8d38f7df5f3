// May a parameter be `in in float`?
void g(in in float x) { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
