// May (a + b)++ be written?
void mainImage(out vec4 c, in vec2 f) {
float a = 1., b = 2.; (a + b)++;
c = vec4(0.0);
}
