// May `half` (reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float half = 1.0;
c.x = half;
c = vec4(0.0);
}
