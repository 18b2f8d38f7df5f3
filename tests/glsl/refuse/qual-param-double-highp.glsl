// May a parameter be `highp highp float`?
void g(highp highp float x) { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
