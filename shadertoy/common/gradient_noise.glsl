// Not in the seed, which has it brought by a tool: Perlin's noise in two dimensions. Each
// corner of a cell slopes its own way; between corners the slopes are blended so smoothly
// that the second derivatives meet as well.
float slopeFrom(vec2 corner, vec2 away) {
    float angle = 6.2832 * hash(corner);
    return dot(vec2(cos(angle), sin(angle)), away);
}
float cnoise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    vec2 u = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float below = mix(slopeFrom(i, f), slopeFrom(i + vec2(1.0, 0.0), f - vec2(1.0, 0.0)), u.x);
    float above = mix(slopeFrom(i + vec2(0.0, 1.0), f - vec2(0.0, 1.0)),
        slopeFrom(i + 1.0, f - 1.0), u.x);
    return 1.6 * mix(below, above, u.y);
}
