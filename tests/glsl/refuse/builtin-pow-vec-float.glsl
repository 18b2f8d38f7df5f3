// May pow(vec2, float) be called?
void mainImage(out vec4 c, in vec2 f) {
vec2 x = pow(f, 2.);
c = vec4(0.0);
}
