// May a member have an initialiser?
struct S { float x = 1.; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
