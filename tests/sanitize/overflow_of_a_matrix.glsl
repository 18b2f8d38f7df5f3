// not-finite in 8 pixels from (0, 5): mat2(vec2(1e30, 0.0), vec2(0.0, 1e30)) * mat2(vec2(1e30, 0.0), vec2(0.0, 1e30))
void mainImage(out vec4 c, in vec2 p) {
    mat2 m = mat2(floor(p.y) == 5.0 ? 1e30 : 1.0);
    mat2 n = m * m; // here
    c = vec4(n[0], n[1]);
}
