// May a switch be on a float?
void mainImage(out vec4 c, in vec2 f) {
switch (f.x) { case 0: break; }
c = vec4(0.0);
}
