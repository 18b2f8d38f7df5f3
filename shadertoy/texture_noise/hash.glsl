// Not in the seed: one texel takes the place of each hash, so that the two ways of
// making noise differ in nothing else. The texture repeats after 256 cells.
#define TEXTURE_NOISE 1
float textureHash(vec2 p) {
    return textureLod(iChannel0, (p + 0.5) / 256.0, 0.0).x;
}
#if TEXTURE_NOISE
#define hash textureHash
#endif
