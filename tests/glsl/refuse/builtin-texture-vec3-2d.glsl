// May texture(sampler2D, vec3) be called?
void mainImage(out vec4 c, in vec2 f) {
c = texture(iChannel0, vec3(f, 0.));
c = vec4(0.0);
}
