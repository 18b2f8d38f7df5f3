vec4 blurred(sampler2D image, vec2 uv) {
    return texture(image, uv, 3.0);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = blurred(iChannel0, fragCoord / iResolution.xy);
}
