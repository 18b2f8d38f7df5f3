// May #include be used?
#include "common.glsl"
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
