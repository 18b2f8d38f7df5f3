// May vec2(1., 2., 3.) be constructed?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = vec2(1., 2., 3.);
c = vec4(0.0);
}
