// division-by-zero in 1 pixels from (2, 5): vec2(1.0, 4.0) / vec2(2.0, 0.0)
void mainImage(out vec4 c, in vec2 p) {
    vec2 q = floor(p);
    vec2 v = vec2(1.0, 4.0);
    if (q.x == 2.0) {
        vec2 d = vec2(2.0, q.y - 5.0);
        v /= d; // here
    }
    c = v.xyxy;
}
