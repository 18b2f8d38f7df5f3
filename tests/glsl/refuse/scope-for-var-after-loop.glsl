// May the loop variable be used after the loop?
void mainImage(out vec4 c, in vec2 f) {
for (int i = 0; i < 3; i++) c.x += 1.;
c.x = float(i);
c = vec4(0.0);
}
