// May #if use 4294967296?
#if 4294967296
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
