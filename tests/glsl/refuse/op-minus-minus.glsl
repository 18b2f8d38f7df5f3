// May a - -b and a--b be distinguished (a--b)?
void mainImage(out vec4 c, in vec2 f) {
int a = 1, b = 2; int d = a--b;
c = vec4(0.0);
}
