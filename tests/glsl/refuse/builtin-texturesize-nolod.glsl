// May textureSize lack the lod?
void mainImage(out vec4 c, in vec2 f) {
ivec2 s = textureSize(iChannel0);
c = vec4(0.0);
}
