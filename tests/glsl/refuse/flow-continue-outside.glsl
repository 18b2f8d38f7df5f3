// May continue stand outside a loop?
void mainImage(out vec4 c, in vec2 f) {
continue;
c = vec4(0.0);
}
