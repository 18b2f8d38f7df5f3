// May for(;;) have no break?
void mainImage(out vec4 c, in vec2 f) {
for (;;) { c.x += 1.; }
c = vec4(0.0);
}
