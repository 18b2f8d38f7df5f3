// Not in the seed: stones stand on meadows, and are small beside mountains.
#undef SNOW_HEIGHT
#define SNOW_HEIGHT 150.0
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 38.0
// The sun stands behind the camera's shoulder, so that the stones' faces are lit.
#undef SUN_DIR
#define SUN_DIR normalize(vec3(0.75, 0.45, 0.35))
#undef SUN_COL
#define SUN_COL vec3(15.0, 11.0, 7.0)
#undef MAX_STEPS
#define MAX_STEPS 400
