// May a prototype stand inside a function?
void mainImage(out vec4 c, in vec2 f) {
float q(float x);
c = vec4(0.0);
}
