// May the user declare an input block?
in Blk { vec4 x; };
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
