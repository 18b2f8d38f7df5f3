// May a macro be redefined with whitespace removed (1.0+2.0)?
#define A (1.0 + 2.0)
#define A (1.0+2.0)
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
