// May a struct constructor take an int for a float member?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S s = S(1);
c = vec4(0.0);
}
