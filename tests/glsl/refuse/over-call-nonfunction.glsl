// May a float variable be called?
void mainImage(out vec4 c, in vec2 f) {
float q = 1.; c.x = q(1.);
c = vec4(0.0);
}
