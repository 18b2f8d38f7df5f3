// May a variable be named a__b?
float a__b = 1.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
