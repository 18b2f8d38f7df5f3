// May a struct have a member function?
struct S { float x; float g() { return x; } };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
