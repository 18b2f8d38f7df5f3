// May a swizzle with duplicates be passed to an out parameter?
void g(out vec2 x) { x = vec2(1.); }
void mainImage(out vec4 c, in vec2 f) {
g(c.xx);
c = vec4(0.0);
}
