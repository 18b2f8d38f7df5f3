// May textureOffset take a variable offset?
void mainImage(out vec4 c, in vec2 f) {
ivec2 o = ivec2(1); c = textureOffset(iChannel0, f, o);
c = vec4(0.0);
}
