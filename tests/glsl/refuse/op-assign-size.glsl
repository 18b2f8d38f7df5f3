// May vec2 be assigned a vec3?
void mainImage(out vec4 c, in vec2 f) {
vec2 v; v = vec3(1.);
c = vec4(0.0);
}
