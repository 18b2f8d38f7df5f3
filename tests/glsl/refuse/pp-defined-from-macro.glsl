// May `defined` come from a macro in #if?
#define HAS defined(FOO)
#if HAS
#endif
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
