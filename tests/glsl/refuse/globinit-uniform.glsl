// May a non-const global be initialised from a uniform?
float g = iTime;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
