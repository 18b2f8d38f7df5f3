void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float gain = 1.2.3;
    fragColor = vec4(gain * 1.0e + 0x);
}
