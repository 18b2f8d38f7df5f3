// May a uint literal be 4294967296u?
void mainImage(out vec4 c, in vec2 f) {
uint x = 4294967296u;
c = vec4(0.0);
}
