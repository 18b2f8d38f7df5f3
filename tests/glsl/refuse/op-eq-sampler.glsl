// May samplers be compared with ==?
void mainImage(out vec4 c, in vec2 f) {
bool b = iChannel0 == iChannel1;
c = vec4(0.0);
}
