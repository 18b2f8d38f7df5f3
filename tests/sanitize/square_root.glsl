// domain in 8 pixels from (0, 0): sqrt(-0.5)
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(sqrt(p.x - 1.0)); // here
}
