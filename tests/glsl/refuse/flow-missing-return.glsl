// May a float function lack a return?
float g() { }
void mainImage(out vec4 c, in vec2 f) {
c.x = g();
c = vec4(0.0);
}
