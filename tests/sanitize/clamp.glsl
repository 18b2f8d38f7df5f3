// limits in 24 pixels from (5, 0): clamp(0.5, 5.0, 4.0)
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(clamp(0.5, floor(p.x), 4.0)); // here
}
