// May else stand without if?
void mainImage(out vec4 c, in vec2 f) {
else c.x = 1.;
c = vec4(0.0);
}
