// May #pragma STDGL invariant(all) be written in a fragment shader?
#pragma STDGL invariant(all)
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
