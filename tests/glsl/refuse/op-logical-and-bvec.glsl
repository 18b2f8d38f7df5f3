// May && be applied to bvec2?
void mainImage(out vec4 c, in vec2 f) {
bvec2 b = bvec2(true) && bvec2(false);
c = vec4(0.0);
}
