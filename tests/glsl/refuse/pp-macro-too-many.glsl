// May a macro be called with too many arguments?
#define A(x) x
void mainImage(out vec4 c, in vec2 f) {
c.x = A(1.0, 2.0);
c = vec4(0.0);
}
