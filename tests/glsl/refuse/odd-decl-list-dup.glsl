// May one list declare a name twice?
float x, x;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
