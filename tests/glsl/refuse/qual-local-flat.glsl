// May a local variable be `flat int`?
void mainImage(out vec4 c, in vec2 f) {
flat int x;
c = vec4(0.0);
}
