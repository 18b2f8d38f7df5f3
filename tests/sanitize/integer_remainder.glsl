// integer-division in 8 pixels from (0, 0): uvec2(7u, 9u) % uvec2(1u, 0u)
void mainImage(out vec4 c, in vec2 p) {
    uvec2 n = uvec2(7, 9);
    n %= uvec2(1, int(p.y)); // here
    c = vec4(n, 0, 1);
}
