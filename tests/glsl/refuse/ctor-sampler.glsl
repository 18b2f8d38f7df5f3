// May sampler2D(0) be constructed?
void mainImage(out vec4 c, in vec2 f) {
c = texture(sampler2D(0), f);
c = vec4(0.0);
}
