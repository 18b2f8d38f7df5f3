// May a user uniform be an unsized array?
uniform float u[];
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
