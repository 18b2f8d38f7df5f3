// May a ternary condition be an int?
void mainImage(out vec4 c, in vec2 f) {
float y = 1 ? 1. : 0.;
c = vec4(0.0);
}
