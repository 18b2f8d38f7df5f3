// May #elif without expression stand after #if 0?
#if 0
#elif
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
