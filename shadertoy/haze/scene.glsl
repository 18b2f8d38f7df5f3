// Not in the seed, which says how a scene is moved: the land goes by below an eye that stands
// still. Its light lies at height 0, so that the land is put about there.
#define TERRAIN_SCALE 0.3
#define TERRAIN_HEIGHT 2.6
#define GROUND 1.5
#define STEP_FACTOR 0.5
float scene(vec3 p) {
    p.z += 2.0 * uTime;
    float height = TERRAIN_HEIGHT * terrain(p.xz * TERRAIN_SCALE) / TERRAIN_SCALE;
    return STEP_FACTOR * (p.y + GROUND - height);
}
#undef MAX_STEPS
#define MAX_STEPS 120
#undef SURFACE_DIST
#define SURFACE_DIST 0.04
#define SHADOW_STEPS 24
#define getNormal(p) getNormalAt(p, distance(p, ro))
vec3 lightPosition = vec3(-1.0, 0.0, 0.5);
