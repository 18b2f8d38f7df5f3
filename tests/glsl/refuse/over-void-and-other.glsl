// May parameters be (void, float x)?
float g(void, float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
