// May an argument list end with a comma?
float g(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {
c.x = g(1.,);
c = vec4(0.0);
}
