// May a literal be passed to an inout parameter?
void g(inout float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {
g(1.);
c = vec4(0.0);
}
