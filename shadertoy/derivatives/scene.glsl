// Not in the seed: where the ground lies, and at which scale. Eight octaves of it are finer
// than a pixel unless it is seen large.
#define TERRAIN_SCALE 0.3
#define TERRAIN_HEIGHT 2.6
#define STEP_FACTOR 0.5
float scene(vec3 p) {
    float height = TERRAIN_HEIGHT * terrain(p.xz * TERRAIN_SCALE) / TERRAIN_SCALE;
    return STEP_FACTOR * (p.y - height);
}
#undef MAX_STEPS
#define MAX_STEPS 120
#undef MAX_DIST
#define MAX_DIST 160.0
#undef SURFACE_DIST
#define SURFACE_DIST 0.04
#define SHADOW_STEPS 24
#undef EYE
#define EYE vec3(1.5 * uTime, 24.0, -3.0 * uTime)
#undef AIM
#define AIM (ro + vec3(0.3, -0.25, -1.0))
#undef PAINT
#define PAINT mix(vec3(0.17, 0.14, 0.12), vec3(0.10, 0.12, 0.05), smoothstep(0.80, 0.95, normal.y))
#define SKY vec3(0.55, 0.66, 0.80)
