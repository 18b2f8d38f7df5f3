// May a ternary with two int branches initialise a float?
void mainImage(out vec4 c, in vec2 f) {
float y = f.x > 0. ? 1 : 0;
c = vec4(0.0);
}
