// May GL_ES be undefined?
#undef GL_ES
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
