// May the user define main(int)?
void main(int i) { }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
