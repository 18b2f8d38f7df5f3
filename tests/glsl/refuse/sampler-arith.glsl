// May a sampler be used in arithmetic?
void mainImage(out vec4 c, in vec2 f) {
c = iChannel0 + 1.;
c = vec4(0.0);
}
