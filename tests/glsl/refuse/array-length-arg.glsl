// May .length(1) take an argument?
void mainImage(out vec4 c, in vec2 f) {
float a[3]; int n = a.length(1);
c = vec4(0.0);
}
