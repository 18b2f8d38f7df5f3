// division-by-zero in 8 pixels from (0, 6): mat2(vec2(1.0, 0.0), vec2(0.0, 1.0)) / 0.0
void mainImage(out vec4 c, in vec2 p) {
    float d = floor(p.y) - 6.0;
    mat2 m = mat2(1.0) / d; // here
    c = vec4(m[0], m[1]);
}
