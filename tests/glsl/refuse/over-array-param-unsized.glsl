// May a parameter be an unsized array?
float g(float x[]) { return x[0]; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
