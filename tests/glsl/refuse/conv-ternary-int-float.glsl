// May a ternary mix int and float branches?
void mainImage(out vec4 c, in vec2 f) {
float y = f.x > 0. ? 1 : 0.5;
c = vec4(0.0);
}
