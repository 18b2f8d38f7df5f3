// May a member of a function result be assigned?
struct S { float x; };
S g() { return S(1.); }
void mainImage(out vec4 c, in vec2 f) {
g().x = 2.;
c = vec4(0.0);
}
