// division-by-zero in 1 pixels from (3, 3): 1.0 / 0.0
float share(float x) {
    return 1.0 / x; // here
}
void mainImage(out vec4 c, in vec2 p) {
    vec2 q = floor(p);
    float sum = 0.0;
    for (int i = 0; i < 10; i++) sum += share(q == vec2(3.0) ? 0.0 : 2.0);
    c = vec4(sum + share(q == vec2(3.0) ? 0.0 : 2.0));
}
