// Not in the seed: the heightfield, of waves that run five ways with ever sharper crests.
// The seed counts heights downward, which makes `h + y` the distance, so this is a depth.
#define HEIGHT 1.3
// The steepest slope of this heightfield, measured over its whole plane; tests/suite/lipschitz.rs
// repeats the measurement. It grows with HEIGHT in proportion.
#define STEEPEST (SLOPE * HEIGHT)
#define SLOPE 2.45
float h(vec2 p) {
    float height = 0.0, weight = 1.0, frequency = 0.7;
    vec2 way = vec2(1.0, 0.0);
    for (int i = 0; i < 5; i++) {
        float wave = 0.5 + 0.5 * sin(frequency * dot(p, way) + 1.3 * float(i));
        height += weight * wave * wave * wave * wave;
        // A golden angle further, so that the waves never line up.
        way = mat2(-0.7374, -0.6755, 0.6755, -0.7374) * way;
        frequency *= 1.7;
        weight *= 0.62;
    }
    return -HEIGHT * height;
}
