// May a global be initialised from itself?
float g = g;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
