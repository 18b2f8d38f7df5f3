// May an array constructor end with a comma?
void mainImage(out vec4 c, in vec2 f) {
float a[2] = float[2](1., 2.,);
c = vec4(0.0);
}
