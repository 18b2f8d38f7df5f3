// May a builtin function be redefined with the same signature?
float sin(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
