// May a float function return an int literal?
float g() { return 1; }
void mainImage(out vec4 c, in vec2 f) {
float y = g();
c = vec4(0.0);
}
