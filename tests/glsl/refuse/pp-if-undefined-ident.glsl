// May #if use an undefined identifier?
#if FOO
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
