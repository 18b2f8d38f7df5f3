// division-by-zero in 8 pixels from (3, 0): mod(7.0, 0.0)
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(mod(7.0, floor(p.x) - 3.0)); // here
}
