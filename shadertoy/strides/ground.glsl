// Not in the seed: it leaves the height function to its reader. Ridges come of noise that is
// folded over at its middle, and each octave is turned against the last.
#define TERRAIN_OCTAVES 6
#define TERRAIN_HEIGHT 3.2
const mat2 turn = mat2(1.62, 1.18, -1.18, 1.62);
float f(float x, float z) {
    vec2 p = 0.16 * vec2(x, z);
    float height = 0.0, weight = 0.5;
    for (int i = 0; i < TERRAIN_OCTAVES; i++) {
        float fold = 1.0 - abs(2.0 * noise(p) - 1.0);
        height += weight * fold * fold;
        weight *= 0.42;
        p = turn * p;
    }
    return TERRAIN_HEIGHT * height;
}
