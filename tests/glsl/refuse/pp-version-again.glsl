// May #version stand in user code?
#version 300 es
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
