// May a char literal be written?
void mainImage(out vec4 c, in vec2 f) {
int x = 'a';
c = vec4(0.0);
}
