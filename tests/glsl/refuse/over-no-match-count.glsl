// May a function be called with too few arguments?
float g(float x, float y) { return x + y; }
void mainImage(out vec4 c, in vec2 f) {
c.x = g(1.);
c = vec4(0.0);
}
