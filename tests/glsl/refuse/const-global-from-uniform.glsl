// May a global const be initialised from a uniform?
const float A = iTime;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
