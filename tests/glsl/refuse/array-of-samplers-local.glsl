// May a local array of samplers be built?
void mainImage(out vec4 c, in vec2 f) {
sampler2D t[2] = sampler2D[2](iChannel0, iChannel1);
c = vec4(0.0);
}
