// May structs be compared with <?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S a, b; bool q = a < b;
c = vec4(0.0);
}
