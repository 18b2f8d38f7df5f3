// May % be applied to floats?
void mainImage(out vec4 c, in vec2 f) {
float x = f.x % 2.;
c = vec4(0.0);
}
