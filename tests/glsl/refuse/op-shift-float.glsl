// May float << int be written?
void mainImage(out vec4 c, in vec2 f) {
float x = f.x << 1;
c = vec4(0.0);
}
