// May an array of void be declared?
void mainImage(out vec4 c, in vec2 f) {
void a[2];
c = vec4(0.0);
}
