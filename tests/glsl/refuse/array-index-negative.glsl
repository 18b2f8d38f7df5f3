// May a constant index be -1?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; c.x = a[-1];
c = vec4(0.0);
}
