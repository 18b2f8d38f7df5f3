// integer-division in 8 pixels from (7, 0): -2147483648 / -1
void mainImage(out vec4 c, in vec2 p) {
    int lowest = -2147483647 - int(p.x > 7.0);
    c = vec4(lowest / (iFrame - iFrame - 1)); // here
}
