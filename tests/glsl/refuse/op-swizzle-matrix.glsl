// May a matrix be swizzled (m.x)?
void mainImage(out vec4 c, in vec2 f) {
mat2 m; vec2 v = m.x;
c = vec4(0.0);
}
