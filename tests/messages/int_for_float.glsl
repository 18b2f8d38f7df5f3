void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    int steps = 10.0;
    fragColor = vec4(float(steps));
}
