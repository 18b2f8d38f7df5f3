// May a macro call be unterminated at end of file?
#define A(x) x
float y = A(1.0
;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
