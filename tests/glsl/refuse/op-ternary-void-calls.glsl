// May a ternary have void function calls as branches?
void g() { }
void h() { }
void mainImage(out vec4 c, in vec2 f) {
f.x > 0. ? g() : h();
c = vec4(0.0);
}
