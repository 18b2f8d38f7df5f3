// domain in 1 pixels from (4, 4): atan(0.0, 0.0)
void mainImage(out vec4 c, in vec2 p) {
    vec2 d = floor(p) - 4.0;
    c = vec4(atan(d.y, d.x)); // here
}
