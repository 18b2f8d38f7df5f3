// May a float function `return;`?
float g() { return; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
