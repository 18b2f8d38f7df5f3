// May tokens follow #else?
#if 1
#else foo
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
