// May a declaration lack its semicolon?
float a
float b;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
