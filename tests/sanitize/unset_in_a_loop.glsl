// unset-variable in 64 pixels from (0, 0)
void mainImage(out vec4 c, in vec2 p) {
    float sum = 0.0;
    for (int i = 0; i < 3; i++) {
        float x;
        if (i == 1) sum += x; // here
        x = 1.0;
        sum += x;
    }
    c = vec4(sum);
}
