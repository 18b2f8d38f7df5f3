#iUniform vec3 tint = vec2(1.0, 0.5)

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(1.0);
}
