// May a switch end with a label without statement?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 0: c.x = 1.; break; case 1: }
c = vec4(0.0);
}
