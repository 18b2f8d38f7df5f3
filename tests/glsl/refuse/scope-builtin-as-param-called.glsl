// May a builtin be called where a parameter hides it?
float g(float mix) { return mix(1., 2., mix); }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
