void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float brightness = vec3(0.5);
    fragColor = vec4(brightness);
}
