// May a struct be empty?
struct S { };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
