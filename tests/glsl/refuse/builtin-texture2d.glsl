// May texture2D be called?
void mainImage(out vec4 c, in vec2 f) {
c = texture2D(iChannel0, f);
c = vec4(0.0);
}
