// division-by-zero in 8 pixels from (3, 0): 2.0 / 0.0
void mainImage(out vec4 c, in vec2 p) {
    float d = floor(p.x) - 3.0;
    c = vec4(2.0 / d); // here
}
