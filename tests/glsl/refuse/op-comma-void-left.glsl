// May a comma expression have a void left operand?
void g() { }
void mainImage(out vec4 c, in vec2 f) {
float x = (g(), 2.);
c = vec4(0.0);
}
