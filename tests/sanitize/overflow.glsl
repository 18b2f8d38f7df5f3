// not-finite in 8 pixels from (6, 0): 3e38 + 3e38
void mainImage(out vec4 c, in vec2 p) {
    float big = p.x > 6.0 && p.x < 7.0 ? 3e38 : 3.0;
    float x = 1.0 - 0.5 * (big + big); // here
    c = vec4(x * 2.0, x - x, 1.0 / x, 1.0);
}
