// May texelFetch take a vec2?
void mainImage(out vec4 c, in vec2 f) {
c = texelFetch(iChannel0, f, 0);
c = vec4(0.0);
}
