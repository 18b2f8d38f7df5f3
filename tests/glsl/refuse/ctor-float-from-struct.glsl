// May float(struct) be constructed?
void mainImage(out vec4 c, in vec2 f) {
struct S { float x; }; S s;
float v = float(s);
c = vec4(0.0);
}
