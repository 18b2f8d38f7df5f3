// May a ; follow a function body?
float g() { return 1.; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
