// May a plain global be `flat int`?
flat int x;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
