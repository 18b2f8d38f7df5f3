// May a function be called where a local hides it?
float q(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {
float q = 1.0; c.x = q(2.0);
c = vec4(0.0);
}
