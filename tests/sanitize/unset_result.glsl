// unset-variable in 64 pixels from (0, 0)
void brighten(out float x, float by) {
    x += by; // here
}
void mainImage(out vec4 c, in vec2 p) {
    float x = 1.0;
    brighten(x, 0.5);
    c = vec4(x);
}
