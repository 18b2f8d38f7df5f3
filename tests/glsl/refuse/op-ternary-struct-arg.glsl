// May a ternary of structs be an argument?
struct S { float x; };
float g(S s) { return s.x; }
void mainImage(out vec4 c, in vec2 f) {
S a, b; c.x = g(f.x > 0. ? a : b);
c = vec4(0.0);
}
