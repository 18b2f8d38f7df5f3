// May a fragment input gl_FragCoord be assigned?
void mainImage(out vec4 c, in vec2 f) {
gl_FragCoord = vec4(0.);
c = vec4(0.0);
}
