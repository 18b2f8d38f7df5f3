// May an integer literal have suffix f (1f)?
void mainImage(out vec4 c, in vec2 f) {
float x = 1f;
c = vec4(0.0);
}
