// index-out-of-range in 32 pixels from (4, 0): [4]
void mainImage(out vec4 c, in vec2 p) {
    float a[4];
    a[0] = a[1] = a[2] = a[3] = 0.5;
    c = vec4(a[int(p.x)]); // here
}
