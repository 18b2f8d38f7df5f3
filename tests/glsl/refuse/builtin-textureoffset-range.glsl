// May textureOffset take an offset of 8 (max 7)?
void mainImage(out vec4 c, in vec2 f) {
c = textureOffset(iChannel0, f, ivec2(8, 0));
c = vec4(0.0);
}
