// May vec3(vec2) be constructed?
void mainImage(out vec4 c, in vec2 f) {
vec3 v = vec3(f);
c = vec4(0.0);
}
