// May #if hold a non-ASCII letter?
#if é
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
