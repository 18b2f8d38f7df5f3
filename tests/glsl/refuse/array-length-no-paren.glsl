// May .length be used without parentheses?
void mainImage(out vec4 c, in vec2 f) {
float a[3]; int n = a.length;
c = vec4(0.0);
}
