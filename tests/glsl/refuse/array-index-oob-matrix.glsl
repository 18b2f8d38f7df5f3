// May mat2 be indexed by [2]?
void mainImage(out vec4 c, in vec2 f) {
mat2 m = mat2(1.); c.xy = m[2];
c = vec4(0.0);
}
