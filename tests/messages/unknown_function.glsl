void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(nois(fragCoord), 0.0, 0.0, 1.0);
}
