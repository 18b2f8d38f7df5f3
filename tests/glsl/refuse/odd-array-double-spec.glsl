// May `float[2] x[3]` be declared?
float[2] x[3];
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
