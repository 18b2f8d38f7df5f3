// failed assertions paint the picture red, green, blue or yellow, by their number
// expect-at: 0 0 255 0 0
// expect-at: 1 0 0 255 0
// expect-at: 2 0 0 0 255
// expect-at: 3 0 255 255 0
// expect-at: 4 0 51 51 51
void mainImage(out vec4 o, in vec2 p) {
    int x = int(p.x);
    st_assert(x != 0);
    st_assert(x != 1, 1);
    st_assert(x != 2, 2);
    st_assert(x != 3, 3);
    o = vec4(0.2);
}
