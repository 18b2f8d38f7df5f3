// May a sampler array parameter be indexed dynamically?
vec4 g(sampler2D s[2], int i) { return texture(s[i], vec2(0.)); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
