// May .length() be called on a vector?
void mainImage(out vec4 c, in vec2 f) {
int n = f.length();
c = vec4(0.0);
}
