// May `goto` (reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float goto = 1.0;
c.x = goto;
c = vec4(0.0);
}
