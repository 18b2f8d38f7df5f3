// May a prototype say `float` and the definition `const in float`?
float g(float x);
float g(const in float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
