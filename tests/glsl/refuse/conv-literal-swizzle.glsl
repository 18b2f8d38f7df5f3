// May a float literal be swizzled, (1.).xx?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = (1.).xx;
c = vec4(0.0);
}
