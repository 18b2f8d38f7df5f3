// May gl_FragCoord.x be written?
void mainImage(out vec4 c, in vec2 f) {
gl_FragCoord.x = 1.;
c = vec4(0.0);
}
