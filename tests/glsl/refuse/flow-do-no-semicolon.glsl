// May do-while lack the final semicolon?
void mainImage(out vec4 c, in vec2 f) {
int i = 0; do { i++; } while (i < 3)
c = vec4(0.0);
}
