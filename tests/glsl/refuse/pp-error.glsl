// May #error be reached?
#error stop here
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
