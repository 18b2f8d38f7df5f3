// May an expression be passed to an out parameter?
void g(out float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {
float y; g(y + 1.);
c = vec4(0.0);
}
