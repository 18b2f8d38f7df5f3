// May an int literal be passed where a float parameter is expected?
float g(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {
float y = g(1);
c = vec4(0.0);
}
