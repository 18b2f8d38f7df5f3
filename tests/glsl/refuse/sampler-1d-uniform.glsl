// May a uniform sampler1D be declared?
uniform sampler1D s;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
