// May a uniform have an initialiser?
uniform float myUniform = 1.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
