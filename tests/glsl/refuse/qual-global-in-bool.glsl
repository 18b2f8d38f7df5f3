// May the user declare `in bool`?
in bool myIn;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
