// negative-base in 24 pixels from (0, 0): pow(-3.0, 2.0)
void mainImage(out vec4 c, in vec2 p) {
    float two = 2.0 + float(iFrame - iFrame);
    c = vec4(pow(floor(p.x) - 3.0, two)); // here
}
