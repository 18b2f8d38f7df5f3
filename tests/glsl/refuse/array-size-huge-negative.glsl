// May an array have size 4294967295u?
void mainImage(out vec4 c, in vec2 f) {
float a[4294967295u];
c = vec4(0.0);
}
