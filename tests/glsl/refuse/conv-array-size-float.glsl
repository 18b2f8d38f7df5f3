// May an array size be a float literal?
void mainImage(out vec4 c, in vec2 f) {
float a[2.0];
c = vec4(0.0);
}
