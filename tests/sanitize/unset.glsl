// unset-variable in 16 pixels from (0, 0)
float share(float x) {
    float result;
    if (x > 2.0) result = x;
    return result; // here
}
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(share(p.x));
}
