// May clamp(float, vec2, vec2) be called?
void mainImage(out vec4 c, in vec2 f) {
vec2 x = clamp(0., f, f);
c = vec4(0.0);
}
