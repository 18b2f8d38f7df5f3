// May a struct have an unsized array member?
struct S { float x[]; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
