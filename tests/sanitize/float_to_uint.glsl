// conversion in 8 pixels from (0, 0): uint(vec2(-1.0, 2.0))
void mainImage(out vec4 c, in vec2 p) {
    uvec2 n = uvec2(vec2(floor(p.x) - 1.0, 2.0)); // here
    c = vec4(n, 0, 1);
}
