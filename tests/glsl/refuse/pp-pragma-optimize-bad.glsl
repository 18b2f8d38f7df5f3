// May #pragma optimize(foo) be written?
#pragma optimize(foo)
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
