// Not in the seed: from here on TERRAIN_HEIGHT only stands for the plane at which rays are
// clipped. The seed's own 120.0 lies below the summits and cuts them off flat: the octaves
// sum to almost twice as much. No ray begins above the plane that CLIP 0 sets.
#define CLIP 1
#define UPPER_BOUND 240.0
#undef TERRAIN_HEIGHT
#if CLIP
#define TERRAIN_HEIGHT UPPER_BOUND
#else
#define TERRAIN_HEIGHT 1e9
#endif
