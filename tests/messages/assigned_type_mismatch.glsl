void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 colour = vec3(0.5);
    fragColor = colour;
}
