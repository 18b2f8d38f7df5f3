// May #if use a macro that is empty?
#define A
#if A
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
