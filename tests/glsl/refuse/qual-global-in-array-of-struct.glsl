// May a fragment input be an array of structs?
struct S { float x; };
in S s[2];
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
