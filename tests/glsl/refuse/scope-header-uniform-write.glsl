// May a uniform be assigned?
void mainImage(out vec4 c, in vec2 f) {
iTime = 1.0;
c = vec4(0.0);
}
