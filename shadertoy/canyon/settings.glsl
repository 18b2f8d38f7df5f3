// Not in the seed: its displacement is three units deep, so this world is small, and
// so are its distances. The sun is higher, to reach into the canyon.
#undef MAX_STEPS
#define MAX_STEPS 220
#undef MAX_DIST
#define MAX_DIST 240.0
#undef SHADOW_STEPS
#define SHADOW_STEPS 40
#undef FOG_DENSITY
#define FOG_DENSITY 0.002
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 9.0
#undef SUN_DIR
#define SUN_DIR normalize(vec3(0.8, 0.7, -0.5))
// What light the shade gets has been thrown back by the walls.
#undef SKY_COL
#define SKY_COL vec3(0.80, 0.66, 0.55)
