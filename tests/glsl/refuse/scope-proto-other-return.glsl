// May a prototype differ in return type from the definition?
int g(float x);
float g(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
