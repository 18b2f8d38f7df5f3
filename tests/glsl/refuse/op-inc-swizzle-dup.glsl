// May a swizzle with duplicates be incremented?
void mainImage(out vec4 c, in vec2 f) {
vec3 v = vec3(1.); v.xx++;
c = vec4(0.0);
}
