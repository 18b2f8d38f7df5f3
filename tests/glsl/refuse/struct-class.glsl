// May class be used?
class S { float x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
