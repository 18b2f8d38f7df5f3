// May a const struct with a sampler member be declared?
struct S { sampler2D t; };
const S s;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
