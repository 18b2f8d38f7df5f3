// integer-division in 8 pixels from (0, 2): 7 / 0
void mainImage(out vec4 c, in vec2 p) {
    int d = int(p.y) - 2;
    c = vec4(7 / d); // here
}
