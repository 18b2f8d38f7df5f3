// May float[]() be constructed?
void mainImage(out vec4 c, in vec2 f) {
float a[1] = float[]();
c = vec4(0.0);
}
