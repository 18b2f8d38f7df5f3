// May &&= be used?
void mainImage(out vec4 c, in vec2 f) {
bool x = true; x &&= false;
c = vec4(0.0);
}
