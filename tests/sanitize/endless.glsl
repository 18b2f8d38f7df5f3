// endless-loop in 2 pixels from (0, 1)
void mainImage(out vec4 c, in vec2 p) {
    vec2 q = floor(p);
    float t = q.y == 1.0 && q.x < 2.0 ? 0.0 : 1.0;
    while (t < 4.0) t *= 2.0; // here
    c = vec4(t);
}
