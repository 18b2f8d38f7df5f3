void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord * vec3(1.0), 1.0);
}
