// May a struct constructor have too few arguments?
struct S { float x; float y; };
void mainImage(out vec4 c, in vec2 f) {
S s = S(1.);
c = vec4(0.0);
}
