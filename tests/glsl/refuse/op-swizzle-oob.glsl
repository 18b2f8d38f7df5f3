// May vec2.z be read?
void mainImage(out vec4 c, in vec2 f) {
float x = f.z;
c = vec4(0.0);
}
