// May a ternary yield structs?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S a, b; S d = f.x > 0. ? a : b;
c = vec4(0.0);
}
