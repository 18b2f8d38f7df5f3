// May an identifier hold a non-ASCII letter?
float café = 1.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
