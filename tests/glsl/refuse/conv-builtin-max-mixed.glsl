// May max(float, int literal) be called?
void mainImage(out vec4 c, in vec2 f) {
float y = max(f.x, 0);
c = vec4(0.0);
}
