// May a global const be initialised by a comma expression?
const float A = (1.0, 2.0);
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
