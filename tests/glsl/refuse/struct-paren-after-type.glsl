// May `float(x) = 1.` declare x?
void mainImage(out vec4 c, in vec2 f) {
float(x) = 1.;
c = vec4(0.0);
}
