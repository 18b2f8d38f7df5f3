// May a ternary be passed to an out parameter?
void g(out float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {
float a, b; g(f.x > 0. ? a : b);
c = vec4(0.0);
}
