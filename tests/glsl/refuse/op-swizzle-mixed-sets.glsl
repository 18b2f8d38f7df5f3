// May a swizzle mix sets (c.xg)?
void mainImage(out vec4 c, in vec2 f) {
c.xy = c.xg;
c = vec4(0.0);
}
