// May vec2[2] index out of range?
void mainImage(out vec4 c, in vec2 f) {
c.x = f[2];
c = vec4(0.0);
}
