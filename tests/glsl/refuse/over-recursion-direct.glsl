// May a function call itself?
float g(float x) { return x > 0. ? g(x - 1.) : 0.; }
void mainImage(out vec4 c, in vec2 f) {
c.x = g(1.);
c = vec4(0.0);
}
