// May `float[2] a[3]` be declared?
void mainImage(out vec4 c, in vec2 f) {
float[2] a[3];
c = vec4(0.0);
}
