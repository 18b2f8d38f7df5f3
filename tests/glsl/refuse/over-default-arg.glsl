// May a parameter have a default value?
float g(float x = 1.) { return x; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
