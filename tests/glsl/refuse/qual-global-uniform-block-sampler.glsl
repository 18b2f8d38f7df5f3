// May a uniform block contain a sampler?
uniform Blk { sampler2D x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
