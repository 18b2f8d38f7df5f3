// May a usampler2D uniform be declared without any precision?
uniform usampler2D u;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
