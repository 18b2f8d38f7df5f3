// May a label statement be used?
void mainImage(out vec4 c, in vec2 f) {
lab: c.x = 1.;
c = vec4(0.0);
}
