// May textureGather be called?
void mainImage(out vec4 c, in vec2 f) {
c = textureGather(iChannel0, f);
c = vec4(0.0);
}
