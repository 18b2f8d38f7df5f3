// May ! be applied to an int?
void mainImage(out vec4 c, in vec2 f) {
bool b = !1;
c = vec4(0.0);
}
