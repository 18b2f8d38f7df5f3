// May a const in parameter be passed to an inout parameter?
void g(inout float x) { x = 1.; }
void h(const in float y) { g(y); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
