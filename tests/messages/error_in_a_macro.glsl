#define GLOW(d) (0.02 / abs(d) * brightnes)
#define RING(p, r) GLOW(length(p) - r)

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 p = fragCoord / iResolution.xy - 0.5;
    fragColor = vec4(RING(p, 0.3));
}
