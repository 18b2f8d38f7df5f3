// Not in the seed: gullies show their branches from above, so the flight is higher
// than the template's.
#undef CAM_ALTITUDE
#define CAM_ALTITUDE 70.0
