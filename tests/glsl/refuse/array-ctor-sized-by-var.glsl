// May float[n](...) with variable n be constructed?
void mainImage(out vec4 c, in vec2 f) {
int n = 2; float a[2] = float[n](1., 2.);
c = vec4(0.0);
}
