// May a function be named `sample`?
float sample(vec2 p) { return p.x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
