// May for(int i=0; true; i++) have no break?
void mainImage(out vec4 c, in vec2 f) {
for (int i = 0; true; i++) { c.x += 1.; }
c = vec4(0.0);
}
