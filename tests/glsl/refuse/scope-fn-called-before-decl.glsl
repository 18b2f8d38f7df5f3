// May a function be called before its declaration?
float h() { return g(1.); }
float g(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
