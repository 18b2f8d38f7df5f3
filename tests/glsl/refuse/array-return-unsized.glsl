// May a function return float[]?
float[] g() { return float[](1., 2.); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
