// May an array be initialised with braces {1., 2.}?
void mainImage(out vec4 c, in vec2 f) {
float a[2] = {1., 2.};
c = vec4(0.0);
}
