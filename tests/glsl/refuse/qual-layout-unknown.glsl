// May `layout(foo) uniform;` be written?
layout(foo) uniform;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
