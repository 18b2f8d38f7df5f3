// May a statement precede the first label?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { c.x = 1.; case 0: break; }
c = vec4(0.0);
}
