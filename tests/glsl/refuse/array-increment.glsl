// May an array be incremented?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; a++;
c = vec4(0.0);
}
