// May fma be called?
void mainImage(out vec4 c, in vec2 f) {
float x = fma(1., 2., 3.);
c = vec4(0.0);
}
