// index-out-of-range in 60 pixels from (2, 0): ivec2(1, 0)
void mainImage(out vec4 c, in vec2 p) {
    // A channel to which nothing is bound has one texel.
    c = texelFetch(iChannel0, ivec2(p) / 2, 0); // here
}
