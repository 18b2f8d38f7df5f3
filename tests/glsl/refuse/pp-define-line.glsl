// May __LINE__ be defined?
#define __LINE__ 3
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
