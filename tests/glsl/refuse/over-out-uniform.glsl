// May a uniform be passed to an out parameter?
void g(out float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {
g(iTime);
c = vec4(0.0);
}
