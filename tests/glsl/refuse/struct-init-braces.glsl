// May a struct be initialised with braces?
struct S { float x; float y; };
void mainImage(out vec4 c, in vec2 f) {
S s = {1., 2.};
c = vec4(0.0);
}
