// May return lack its semicolon?
void mainImage(out vec4 c, in vec2 f) {
return
c = vec4(0.0);
}
