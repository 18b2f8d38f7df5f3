// May a sampler parameter be `out sampler2D`?
vec4 g(out sampler2D s) { return vec4(0.); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
