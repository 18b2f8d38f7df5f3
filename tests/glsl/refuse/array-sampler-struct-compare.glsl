// May uniform structs that hold samplers be compared?
struct S { sampler2D t; float x; };
uniform S a, b;
void mainImage(out vec4 c, in vec2 f) {
bool q = a == b;
c = vec4(0.0);
}
