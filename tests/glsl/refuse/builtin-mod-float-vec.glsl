// May mod(float, vec2) be called?
void mainImage(out vec4 c, in vec2 f) {
vec2 x = mod(2., f);
c = vec4(0.0);
}
