// Not in the seed: summer, as light shafts show best before dark ground.
#undef SNOW_HEIGHT
#define SNOW_HEIGHT 125.0
