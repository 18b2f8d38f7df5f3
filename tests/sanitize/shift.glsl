// shift in 16 pixels from (0, 6): 1 << 36
void mainImage(out vec4 c, in vec2 p) {
    int by = int(p.y) * 6;
    c = vec4(1 << by); // here
}
