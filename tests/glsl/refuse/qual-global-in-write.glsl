// May a fragment input be written?
in vec2 myIn;
void mainImage(out vec4 c, in vec2 f) {
myIn = vec2(1.);
c = vec4(0.0);
}
