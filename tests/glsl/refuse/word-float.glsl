// May `float` (an ES 3.00 keyword) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float float = 1.0;
c.x = float;
c = vec4(0.0);
}
