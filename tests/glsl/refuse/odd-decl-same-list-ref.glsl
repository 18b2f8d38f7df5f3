// May a declarator use an earlier one of the same list?
float x = 1.0, y = x;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
