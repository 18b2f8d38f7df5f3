void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float x = 1.0;
    float x = 2.0;
    fragColor = vec4(x);
}
