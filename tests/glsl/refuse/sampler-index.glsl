// May iChannel0[0] be read?
void mainImage(out vec4 c, in vec2 f) {
c = iChannel0[0];
c = vec4(0.0);
}
