// May an unused function call itself?
float g(float x) { return g(x); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
