// May bools be compared with <?
void mainImage(out vec4 c, in vec2 f) {
bool b = true < false;
c = vec4(0.0);
}
