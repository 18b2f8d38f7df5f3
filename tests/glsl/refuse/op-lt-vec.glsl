// May vectors be compared with <?
void mainImage(out vec4 c, in vec2 f) {
bool b = f < f;
c = vec4(0.0);
}
