// May a prototype say `in` and the definition `out`?
void g(in float x);
void g(out float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
