// May #extension stand inside a function?
float h() {
#extension GL_FOO_bar : enable
return 1.; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
