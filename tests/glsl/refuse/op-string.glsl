// May a string literal be written?
void mainImage(out vec4 c, in vec2 f) {
c.x = "a";
c = vec4(0.0);
}
