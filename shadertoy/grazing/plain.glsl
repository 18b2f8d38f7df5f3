// Not in the seed: gentle ground, and an eye that keeps close to it.
#undef TERRAIN_HEIGHT
#define TERRAIN_HEIGHT 30.0
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 3.0
