// May a float be initialised from an int literal?
void mainImage(out vec4 c, in vec2 f) {
float x = 1;
c = vec4(0.0);
}
