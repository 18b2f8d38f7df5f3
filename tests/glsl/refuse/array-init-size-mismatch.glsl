// May float[3] be initialised with a float[2]?
void mainImage(out vec4 c, in vec2 f) {
float a[3] = float[2](1., 2.);
c = vec4(0.0);
}
