// May a comma expression yield an array?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; float b[2]; b = (1., a);
c = vec4(0.0);
}
