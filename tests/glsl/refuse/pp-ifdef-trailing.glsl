// May tokens follow #ifdef X?
#ifdef A B
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
