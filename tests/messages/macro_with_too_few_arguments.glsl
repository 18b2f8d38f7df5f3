#define RING(p, r) (length(p) - r)

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(RING(fragCoord));
}
