// May a samplerCube parameter get a sampler2D?
vec4 g(samplerCube s) { return texture(s, vec3(0.)); }
void mainImage(out vec4 c, in vec2 f) {
c = g(iChannel0);
c = vec4(0.0);
}
