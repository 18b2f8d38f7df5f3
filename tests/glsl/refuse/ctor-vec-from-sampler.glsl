// May vec4(sampler) be constructed?
void mainImage(out vec4 c, in vec2 f) {
vec4 v = vec4(iChannel0);
c = vec4(0.0);
}
