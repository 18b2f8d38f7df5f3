// May an array have size -1?
void mainImage(out vec4 c, in vec2 f) {
float a[-1];
c = vec4(0.0);
}
