// May a local float[16384] be declared and read?
void mainImage(out vec4 c, in vec2 f) {
float a[16384]; c.x = a[iFrame];
c = vec4(0.0);
}
