float wave(vec2 p) {
    return p;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(wave(fragCoord));
}
