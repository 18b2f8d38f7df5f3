// May #extension GL_OES_standard_derivatives : enable be written?
#extension GL_OES_standard_derivatives : enable
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
