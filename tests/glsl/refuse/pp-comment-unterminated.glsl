// May a block comment be unterminated at the end of the file?
/* this comment never ends
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
