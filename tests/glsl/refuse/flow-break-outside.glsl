// May break stand outside a loop?
void mainImage(out vec4 c, in vec2 f) {
break;
c = vec4(0.0);
}
