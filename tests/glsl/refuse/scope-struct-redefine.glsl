// May a struct be defined twice?
struct S { float x; };
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
