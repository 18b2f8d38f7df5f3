// May a function return a sampler?
sampler2D g() { return iChannel0; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
