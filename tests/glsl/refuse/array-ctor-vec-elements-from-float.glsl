// May vec2[2](1., 2.) be constructed?
void mainImage(out vec4 c, in vec2 f) {
vec2 a[2] = vec2[2](1., 2.);
c = vec4(0.0);
}
