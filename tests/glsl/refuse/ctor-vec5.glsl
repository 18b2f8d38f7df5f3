// May vec5 be used?
void mainImage(out vec4 c, in vec2 f) {
vec5 v;
c = vec4(0.0);
}
