// index-out-of-range in 8 pixels from (0, 0): [-1]
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(0.5);
    c[int(p.x) / 2 - int(p.x < 1.0)] = 1.0; // here
}
