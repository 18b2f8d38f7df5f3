// May an array be indexed by a float variable?
void mainImage(out vec4 c, in vec2 f) {
float a[2] = float[2](1., 2.);
float y = a[f.x];
c = vec4(0.0);
}
