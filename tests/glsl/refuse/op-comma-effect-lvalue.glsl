// May (a = 1., b) = 2. be written (left operand with an effect)?
void mainImage(out vec4 c, in vec2 f) {
float a, b; (a = 1., b) = 2.;
c = vec4(0.0);
}
