// May a global variable have a struct type with a sampler?
struct S { sampler2D t; };
S s;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
