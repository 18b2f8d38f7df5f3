// May a ternary yield arrays?
void mainImage(out vec4 c, in vec2 f) {
float a[2], b[2]; c.x = (f.x > 0. ? a : b)[0];
c = vec4(0.0);
}
