// May the user define max(float, int)?
float max(float a, int b) { return a; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
