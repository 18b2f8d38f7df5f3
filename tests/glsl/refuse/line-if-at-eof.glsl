// May the file end in #if 1 without newline or #endif?
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
#if 1