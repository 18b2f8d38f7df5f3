// May vec2(array) be constructed?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; vec2 v = vec2(a);
c = vec4(0.0);
}
