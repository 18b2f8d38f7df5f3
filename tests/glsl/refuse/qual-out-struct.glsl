// May an output be a struct?
struct S { vec4 x; };
layout(location = 1) out S extra;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
