// May a void function's result be assigned?
void g() { }
void mainImage(out vec4 c, in vec2 f) {
float x = g();
c = vec4(0.0);
}
