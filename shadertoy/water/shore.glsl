// Not in the seed: summer on the shore, seen from a little higher.
#undef SNOW_HEIGHT
#define SNOW_HEIGHT 120.0
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 36.0
// The sun stands to the side, so that the shores are lit.
#undef SUN_DIR
#define SUN_DIR normalize(vec3(0.9, 0.45, -0.15))
