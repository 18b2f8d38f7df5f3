// May a struct member have layout(location)?
struct S { layout(location = 0) float x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
