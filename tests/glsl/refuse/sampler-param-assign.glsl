// May a sampler parameter be assigned?
vec4 g(sampler2D s) { s = iChannel0; return texture(s, vec2(0.)); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
