// May float(1., 2.) be constructed?
void mainImage(out vec4 c, in vec2 f) {
float v = float(1., 2.);
c = vec4(0.0);
}
