// May a switch be on an ivec2?
void mainImage(out vec4 c, in vec2 f) {
switch (ivec2(0)) { case 0: break; }
c = vec4(0.0);
}
