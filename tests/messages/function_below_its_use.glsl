void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(wave(fragCoord.x));
}

float wave(float x) { return 0.5 + 0.5 * sin(x); }
