// May a case label be a float?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 1.0: c.x = 1.; break; }
c = vec4(0.0);
}
