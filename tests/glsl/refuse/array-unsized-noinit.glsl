// May a local array be declared unsized without an initialiser?
void mainImage(out vec4 c, in vec2 f) {
float a[];
c = vec4(0.0);
}
