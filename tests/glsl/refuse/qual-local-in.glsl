// May a local variable be `in float`?
void mainImage(out vec4 c, in vec2 f) {
in float x;
c = vec4(0.0);
}
