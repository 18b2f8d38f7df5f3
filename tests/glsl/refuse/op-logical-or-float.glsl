// May || be applied to floats?
void mainImage(out vec4 c, in vec2 f) {
bool b = f.x || f.y;
c = vec4(0.0);
}
