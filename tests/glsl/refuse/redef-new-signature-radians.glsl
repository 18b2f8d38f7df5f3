// May the user define radians(int, bool, int, bool, int) and call it?
float radians(int a, bool b, int d, bool e, int g) { return 1.; }
void mainImage(out vec4 c, in vec2 f) {
c.x = radians(1, true, 1, true, 1);
c = vec4(0.0);
}
