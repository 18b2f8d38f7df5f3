// May an array of arrays float a[2][3] be declared?
void mainImage(out vec4 c, in vec2 f) {
float a[2][3];
c = vec4(0.0);
}
