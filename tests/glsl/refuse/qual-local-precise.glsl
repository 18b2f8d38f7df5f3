// May a local variable be `precise float`?
void mainImage(out vec4 c, in vec2 f) {
precise float x = 1.;
c = vec4(0.0);
}
