// May arrays be compared with <?
void mainImage(out vec4 c, in vec2 f) {
float a[2], b[2]; bool q = a < b;
c = vec4(0.0);
}
