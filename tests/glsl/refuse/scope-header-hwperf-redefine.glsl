// May HW_PERFORMANCE be redefined with another value?
#define HW_PERFORMANCE 0
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
