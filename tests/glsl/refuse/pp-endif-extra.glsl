// May an extra #endif stand?
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
