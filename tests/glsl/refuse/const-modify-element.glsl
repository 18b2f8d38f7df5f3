// May an element of a const array be assigned?
const float A[3] = float[3](1., 2., 3.);
void mainImage(out vec4 c, in vec2 f) {
A[0] = 2.0;
c = vec4(0.0);
}
