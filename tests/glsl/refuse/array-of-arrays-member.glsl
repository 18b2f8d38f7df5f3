// May a struct member be float x[2][2]?
struct S { float x[2][2]; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
