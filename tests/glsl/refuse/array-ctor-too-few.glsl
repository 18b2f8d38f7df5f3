// May float[3](1., 2.) be constructed?
void mainImage(out vec4 c, in vec2 f) {
float a[3] = float[3](1., 2.);
c = vec4(0.0);
}
