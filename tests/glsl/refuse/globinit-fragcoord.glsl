// May a non-const global be initialised from gl_FragCoord?
vec2 g = gl_FragCoord.xy;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
