// May an unused function hold while(true) without break?
void g() { while (true) { } }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
