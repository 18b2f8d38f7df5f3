// May a non-const global be initialised by a user function call?
float h() { return 1.0; }
float g = h();
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
