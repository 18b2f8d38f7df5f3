// May a parameter be `precise float`?
void g(precise float x) { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
