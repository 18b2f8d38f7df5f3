// May structs of different types be assigned?
struct S { float x; };
struct T { float x; };
void mainImage(out vec4 c, in vec2 f) {
S a; T b; a = b;
c = vec4(0.0);
}
