// May a swizzle have five components?
void mainImage(out vec4 c, in vec2 f) {
vec4 v = f.xyxyx;
c = vec4(0.0);
}
