// division-by-zero in 8 pixels from (4, 0): 0.5 / 0.0
#define SHARE(x, n) ((x) / (n))
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(SHARE(0.5, floor(p.x) - 4.0)); // here
}
