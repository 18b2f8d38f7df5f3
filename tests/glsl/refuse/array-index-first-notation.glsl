// May 0[a] be written?
void mainImage(out vec4 c, in vec2 f) {
float a[3]; c.x = 0[a];
c = vec4(0.0);
}
