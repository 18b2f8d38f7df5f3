// division-by-zero in 8 pixels from (2, 0): 1.0 / 0.0
void mainImage(out vec4 c, in vec2 p) {
    float d = floor(p.x) - 2.0;
    float x = 1.0 / d; // here
    if (d == 0.0) discard;
    c = vec4(x);
}
