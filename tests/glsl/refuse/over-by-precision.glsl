// May functions be overloaded by precision alone (both defined)?
float g(highp float x) { return x; }
float g(lowp float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
