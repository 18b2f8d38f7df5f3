// May an undefined prototype be called by a function that is never called?
float g(float x);
float h() { return g(1.); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
