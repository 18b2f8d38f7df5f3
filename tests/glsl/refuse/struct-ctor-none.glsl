// May S() be called without arguments?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S s = S();
c = vec4(0.0);
}
