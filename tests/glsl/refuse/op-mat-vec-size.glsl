// May mat3 * vec2 be written?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = mat3(1.) * f;
c = vec4(0.0);
}
