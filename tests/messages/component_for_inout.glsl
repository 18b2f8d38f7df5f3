void brighten(inout float x) { x += 0.5; }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(0.0);
    brighten(fragColor.r);
}
