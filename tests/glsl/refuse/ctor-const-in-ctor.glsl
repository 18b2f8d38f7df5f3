// May `const vec2(1.)` be an expression?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = const vec2(1.);
c = vec4(0.0);
}
