// May a const be incremented?
void mainImage(out vec4 c, in vec2 f) {
const int x = 1; x++;
c = vec4(0.0);
}
