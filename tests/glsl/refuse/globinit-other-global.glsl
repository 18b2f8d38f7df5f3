// May a non-const global be initialised from another non-const global?
float a = 1.0;
float b = a * 2.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
