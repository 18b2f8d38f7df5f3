// Not in the seed: dunes and crags out of its terrain, seen large.
#define TERRAIN_SCALE 0.25
#define TERRAIN_HEIGHT 2.6
#define STEP_FACTOR 0.5
float land(vec2 p) {
    return TERRAIN_HEIGHT * terrain(p * TERRAIN_SCALE) / TERRAIN_SCALE;
}
float scene(vec3 p) {
    return STEP_FACTOR * (p.y - land(p.xz));
}
#undef MAX_STEPS
#define MAX_STEPS 140
#undef MAX_DIST
#define MAX_DIST 260.0
#undef SURFACE_DIST
#define SURFACE_DIST 0.03
#define SHADOW_STEPS 32
vec3 lightPosition = normalize(vec3(0.35, 0.22, -1.0));
