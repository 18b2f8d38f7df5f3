// May vec2() be empty?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = vec2();
c = vec4(0.0);
}
