// May a switch have duplicate labels?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 0: break; case 0: break; }
c = vec4(0.0);
}
