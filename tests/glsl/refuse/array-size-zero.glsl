// May an array have size 0?
void mainImage(out vec4 c, in vec2 f) {
float a[0];
c = vec4(0.0);
}
