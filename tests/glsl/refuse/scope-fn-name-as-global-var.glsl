// May a function have the name of a global variable?
float q = 1.0;
float q(float x) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
