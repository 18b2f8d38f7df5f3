// domain in 1 pixels from (6, 1): inversesqrt(0.0)
void mainImage(out vec4 c, in vec2 p) {
    vec2 d = floor(p) - vec2(6.0, 1.0);
    c = vec4(inversesqrt(dot(d, d))); // here
}
