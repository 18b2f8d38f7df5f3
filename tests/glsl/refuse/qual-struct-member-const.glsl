// May a struct member be const?
struct S { const float x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
