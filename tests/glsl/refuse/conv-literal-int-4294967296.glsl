// May an int literal be 4294967296?
void mainImage(out vec4 c, in vec2 f) {
int x = 4294967296;
c = vec4(0.0);
}
