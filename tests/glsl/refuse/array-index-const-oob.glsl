// May a constant index equal the size?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; c.x = a[2];
c = vec4(0.0);
}
