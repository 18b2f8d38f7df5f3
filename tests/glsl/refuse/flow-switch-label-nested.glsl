// May a case label stand in a nested block?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 0: { case 1: c.x = 1.; } break; }
c = vec4(0.0);
}
