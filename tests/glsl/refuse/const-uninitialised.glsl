// May a const be declared without an initialiser?
void mainImage(out vec4 c, in vec2 f) {
const float A;
c = vec4(0.0);
}
