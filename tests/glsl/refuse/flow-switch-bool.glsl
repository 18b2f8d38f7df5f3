// May a switch be on a bool?
void mainImage(out vec4 c, in vec2 f) {
switch (true) { case true: break; }
c = vec4(0.0);
}
