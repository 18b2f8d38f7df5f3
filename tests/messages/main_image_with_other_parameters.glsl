void mainImage(out vec4 fragColor) {
    fragColor = vec4(1.0);
}
