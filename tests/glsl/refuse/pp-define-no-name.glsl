// May #define have no name?
#define
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
