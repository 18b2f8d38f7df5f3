// May a case label be 1u in a switch on int?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 1u: c.x = 1.; break; }
c = vec4(0.0);
}
