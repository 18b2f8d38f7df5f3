// May tokens follow #endif?
#if 1
#endif FOO
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
