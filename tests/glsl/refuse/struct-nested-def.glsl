// May a named struct be defined inside a struct?
struct S { struct T { float x; } t; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
