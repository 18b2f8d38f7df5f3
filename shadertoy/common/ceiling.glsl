// Not in the seed: the FBM's octaves sum to almost twice TERRAIN_HEIGHT, and the
// marchers clip rays at that height, which would cut the summits off flat. From
// here on the name stands for the height that no summit passes.
#undef TERRAIN_HEIGHT
#define TERRAIN_HEIGHT 240.0
