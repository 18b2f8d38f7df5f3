// conversion in 8 pixels from (7, 0): int(7000000000.0)
void mainImage(out vec4 c, in vec2 p) {
    float big = p.x > 7.0 ? 1e9 : 1.0;
    c = vec4(int(floor(p.x) * big)); // here
}
