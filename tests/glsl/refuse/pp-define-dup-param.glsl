// May a function-like macro have duplicate parameters?
#define A(x, x) x
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
