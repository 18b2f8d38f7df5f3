// May a parameter be named `input`?
float g(vec2 input) { return input.x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
