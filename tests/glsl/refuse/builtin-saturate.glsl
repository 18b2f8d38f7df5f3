// May saturate be called?
void mainImage(out vec4 c, in vec2 f) {
float x = saturate(f.x);
c = vec4(0.0);
}
