// May a struct be defined in a parameter?
float g(struct S { float x; } s) { return s.x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
