// May a.size() be called?
void mainImage(out vec4 c, in vec2 f) {
float a[3]; int n = a.size();
c = vec4(0.0);
}
