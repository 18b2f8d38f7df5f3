// Not in the seed: with LOD 0 camera, march and shadows read the ground as finely as the
// normals do, which is the picture that the tiers are to come near at less cost.
#define LOD 1
#if !LOD
#define terrainL terrainH
#define terrainM terrainH
#endif
