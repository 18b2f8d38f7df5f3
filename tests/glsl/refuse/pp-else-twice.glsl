// May #else stand twice?
#if 1
#else
#else
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
