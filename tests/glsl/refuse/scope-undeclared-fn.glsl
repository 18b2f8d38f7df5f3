// May an undeclared function be called?
void mainImage(out vec4 c, in vec2 f) {
c.x = undeclaredFn(1.);
c = vec4(0.0);
}
