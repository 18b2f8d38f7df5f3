// zero-vector in 1 pixels from (3, 2): normalize(vec2(0.0))
void mainImage(out vec4 c, in vec2 p) {
    vec2 d = floor(p) - vec2(3.0, 2.0);
    c = normalize(d).xyxy; // here
}
