// May #if divide by zero?
#if 1 / 0
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
