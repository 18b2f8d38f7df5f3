// May vec4(void call) be constructed?
void mainImage(out vec4 c, in vec2 f) {
vec4 v = vec4(mainImage(c, f));
c = vec4(0.0);
}
