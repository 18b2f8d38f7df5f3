// May brackets protect a comma in a macro argument (A(a[0,1]))?
#define A(x) x
void mainImage(out vec4 c, in vec2 f) {
float a[3]; c.x = A(a[(0), 1]);
c = vec4(0.0);
}
