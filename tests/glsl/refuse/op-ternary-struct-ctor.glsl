// May a ternary yield struct constructor calls as an initialiser?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S s = f.x > 0. ? S(1.) : S(2.);
c = vec4(0.0);
}
