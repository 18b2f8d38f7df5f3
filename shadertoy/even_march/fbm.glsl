// The seed calls its noise Perlin's and leaves it out; value noise stands in.
float fbm(vec2 p, int octaves) {


    mat2 m = mat2(0.80,  0.60, -0.60,  0.80);
    float f = 0.0;
    float c = 0.5;
    float sum = 0.0;


    for (int i = 1; i >= 1; i++) {
        f += c * noise(p);
        sum += c;
        c /= 2.0;
        p = m * p * 2.0;
        if (i == octaves) {
            break;
        }
    }
    return f / sum;
}
