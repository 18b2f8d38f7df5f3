// May ## paste tokens?
#define A(x, y) x ## y
void mainImage(out vec4 c, in vec2 f) {
float ab = 1.; c.x = A(a, b);
c = vec4(0.0);
}
