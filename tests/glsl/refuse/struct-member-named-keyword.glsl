// May a member be named `color.sample` (reserved elsewhere)?
struct S { float sample; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
