// May a local in the function's outermost scope redeclare a parameter?
float g(float x) { float x = 1.0; return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
