// May a macro be named GL_FOO?
#define GL_FOO 1.0
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
