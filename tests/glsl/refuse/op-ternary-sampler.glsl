// May a ternary have sampler branches?
void mainImage(out vec4 c, in vec2 f) {
c = texture(f.x > 0. ? iChannel0 : iChannel1, f);
c = vec4(0.0);
}
