// May functions be overloaded by return type alone?
float g(float x) { return x; }
int g(float x) { return 1; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
