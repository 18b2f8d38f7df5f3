// Not in the seed: the relaxed march sees twice as far as MAX_DIST, so the flight is
// higher and the air clearer than the template's, for the distance to show.
#undef FOG_DENSITY
#define FOG_DENSITY 0.00016
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 90.0
