// May `filter` (reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float filter = 1.0;
c.x = filter;
c = vec4(0.0);
}
