// May frac be called?
void mainImage(out vec4 c, in vec2 f) {
float x = frac(f.x);
c = vec4(0.0);
}
