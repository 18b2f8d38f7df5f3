// May a statement stand at global scope?
float x;
x = 1.0;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
