// May a struct constructor get a vec2 for a float?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S s = S(vec2(1.));
c = vec4(0.0);
}
