// May a while condition declare an int?
void mainImage(out vec4 c, in vec2 f) {
int n = 0;
while (int b = n) { n++; }
c = vec4(0.0);
}
