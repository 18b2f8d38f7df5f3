// Not in the seed: each octave's weight shrinks to 0.4 of the last, where the
// template's shrinks to half, so the ground is smooth at the template's scale. Closer
// and higher ridges bring out the octaves that subtract.
#undef TERRAIN_SCALE
#define TERRAIN_SCALE 0.005
#undef TERRAIN_HEIGHT
#define TERRAIN_HEIGHT 150.0
#undef SNOW_HEIGHT
#define SNOW_HEIGHT 105.0
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 45.0
