// May an unused float function lack a return?
float g() { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
