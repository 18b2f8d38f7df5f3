// May a local be a sampler?
void mainImage(out vec4 c, in vec2 f) {
sampler2D s;
c = vec4(0.0);
}
