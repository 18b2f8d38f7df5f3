// ---- Materials ----
// Not in the seed: a single octave of the texture, for the colours.
float textureNoise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return textureLod(iChannel0, (i + f + 0.5) / 256.0, 0.0).x;
}

// Not in the seed: warm layers of rock, sand on the ledges, and less light in crevices.
vec3 getMaterial(in vec3 pos, in vec3 nor) {
    float grain = displacement(pos * vec3(0.5, 2.0, 0.5));
    float layer = pos.y + 2.0 * textureNoise(pos.xz * 0.05) + 1.5 * grain;
    float band = textureNoise(vec2(layer * 0.9, 0.5));
    float fine = textureNoise(vec2(layer * 3.1, 7.5));
    vec3 col = mix(vec3(0.30, 0.11, 0.05), vec3(0.52, 0.27, 0.12), band);
    col = mix(col, vec3(0.62, 0.44, 0.28), smoothstep(0.65, 0.9, fine));
    col *= 0.6 + 0.7 * grain;
    vec3 sand = vec3(0.55, 0.36, 0.20);
    col = mix(col, sand, smoothstep(0.7, 0.92, nor.y));
    // What the map says some way off the surface tells how open the place is.
    float open = clamp(mapCanyon(pos + nor * 1.5) * 4.0 / 1.5, 0.0, 1.0);
    return col * (0.35 + 0.65 * open);
}
