// May a local be `const const float`?
void mainImage(out vec4 c, in vec2 f) {
const const float x = 1.0;
c = vec4(0.0);
}
