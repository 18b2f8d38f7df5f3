// May two members have the same name?
struct S { float x; float x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
