// May while(true) be left only by discard?
void mainImage(out vec4 c, in vec2 f) {
while (true) { c.x += 1.; if (c.x > 9.) discard; }
c = vec4(0.0);
}
