// May a case label be a range 1..2 or 1 ... 2?
void mainImage(out vec4 c, in vec2 f) {
switch (iFrame) { case 1 ... 2: c.x = 1.; break; }
c = vec4(0.0);
}
