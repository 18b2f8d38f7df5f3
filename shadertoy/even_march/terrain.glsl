float terrain(float x, float z) {
    return fbm(vec2(x, z), 2);
}

// Not in the seed: two octaves alone are smooth hills, so they are the large forms of a land
// that has finer ones too.
#define TERRAIN_OCTAVES 6
#define TERRAIN_HEIGHT 2.4
float land(float x, float z) {
    float hills = terrain(0.45 * x, 0.45 * z);
    return TERRAIN_HEIGHT * (hills * hills + 0.3 * fbm(1.4 * vec2(x, z), TERRAIN_OCTAVES));
}

// Not in the seed: its march takes steps of 0.0001 up to 1000, ten million for a ray that
// hits nothing. It marches through a model of the land instead, at 1 : MODEL_SCALE, which
// ends behind MODEL_RANGE at a wall that every ray hits and that is taken for the sky.
#define MODEL_SCALE 500.0
#define MODEL_RANGE 0.04
vec3 eye;
float landModel(float x, float z) {
    if (length(vec2(x, z) - eye.xz) > MODEL_RANGE) return 1e9;
    return land(x * MODEL_SCALE, z * MODEL_SCALE) / MODEL_SCALE;
}
