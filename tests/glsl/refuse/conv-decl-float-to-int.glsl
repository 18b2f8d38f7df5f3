// May an int be initialised from a float literal?
void mainImage(out vec4 c, in vec2 f) {
int i = 1.0;
c = vec4(0.0);
}
