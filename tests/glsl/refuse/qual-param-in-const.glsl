// May a parameter be `in const float` (order swapped)?
float g(in const float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
