// May a lone dot be a float literal?
void mainImage(out vec4 c, in vec2 f) {
float x = .;
c = vec4(0.0);
}
