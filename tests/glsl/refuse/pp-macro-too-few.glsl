// May a macro be called with too few arguments?
#define A(x, y) x
void mainImage(out vec4 c, in vec2 f) {
c.x = A(1.0);
c = vec4(0.0);
}
