// May float + int literal be written?
void mainImage(out vec4 c, in vec2 f) {
float y = f.x + 1;
c = vec4(0.0);
}
