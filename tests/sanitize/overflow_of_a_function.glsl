// not-finite in 8 pixels from (1, 0): exp(100.0)
void mainImage(out vec4 c, in vec2 p) {
    float x = floor(p.x) == 1.0 ? 100.0 : 1.0;
    float y = sqrt(exp(x) * 2.0); // here
    c = vec4(y) - y;
}
