// May a struct with a sampler be constructed?
struct S { sampler2D t; };
vec4 g(S s) { return texture(s.t, vec2(0.)); }
void mainImage(out vec4 c, in vec2 f) {
c = g(S(iChannel0));
c = vec4(0.0);
}
