// limits in 64 pixels from (0, 0): smoothstep(0.5, 0.2, 0.0625)
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(smoothstep(0.5, 0.2, p.x / 8.0)); // here
}
