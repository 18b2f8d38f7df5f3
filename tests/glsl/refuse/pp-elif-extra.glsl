// May #elif stand without #if?
#elif 1
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
