// May a prototype be called without a definition?
float g(float x);
void mainImage(out vec4 c, in vec2 f) {
c.x = g(1.);
c = vec4(0.0);
}
