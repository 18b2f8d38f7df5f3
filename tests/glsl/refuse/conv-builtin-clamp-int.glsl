// May clamp(vec3, 0, 1) be called?
void mainImage(out vec4 c, in vec2 f) {
vec3 y = clamp(vec3(f.x), 0, 1);
c = vec4(0.0);
}
