// operators and functions of constants may begin a global, also where a comma keeps them from being a constant
// expect: 255 0 51
mat2 m = mat2(0.5 * (1., 2.));
float f = max((3., 0.2), 0.1);

void mainImage(out vec4 c, in vec2 p) {
    c = vec4(m[0][0] * m[1][1], m[0][1] + m[1][0], f, 1.);
}
