// May U+2212 stand for minus?
float x = −1.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
