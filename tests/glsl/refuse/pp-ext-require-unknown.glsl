// May #extension UNKNOWN : require be written?
#extension GL_FOO_bar : require
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
