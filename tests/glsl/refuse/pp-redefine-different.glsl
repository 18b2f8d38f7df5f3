// May a macro be redefined with another value?
#define A 1.0
#define A 2.0
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
