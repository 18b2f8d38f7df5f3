// May atan2 be called?
void mainImage(out vec4 c, in vec2 f) {
float x = atan2(f.y, f.x);
c = vec4(0.0);
}
