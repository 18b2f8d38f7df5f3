// Not in the seed: from high above there is much empty air to skip, and it is clearer.
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 420.0
#undef FOG_DENSITY
#define FOG_DENSITY 0.00012
