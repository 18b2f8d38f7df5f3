float4 tint(float2 p) { return float4(saturate(p), 0.0, 1.0); }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = tint(fragCoord / iResolution.xy);
}
