// May a parameter be `highp in float` (precision first)?
float g(highp in float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
