// Not in the seed, which has the idea in one line: about a tenth of the new frame, nine tenths of those before.
#define NEW_SHARE 0.1 // Share of the new frame; 1 is the template (0.05~1)
#define JITTER 1 // Whether frames look through other points of a pixel
#define TRUST 0.05 // How far distances may part, relatively, for the old frame to count

// Points that fill the pixel evenly (the R2 sequence of Martin Roberts).
vec2 jitterOf(int frame) {
    return float(JITTER) * (fract(float(frame) * vec2(0.7548776662, 0.5698402910)) - 0.5);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    View now = viewAt(iTime);
    vec2 jitter = jitterOf(iFrame);
    vec3 rd = rayThrough(now, fragCoord + jitter);
    float t = raymarch(now.ro, rd);
    vec3 col = shade(now.ro, rd, t);
    // The sky is as far as one can see.
    float away = t > 0.0 ? t : MAX_DIST;
    vec3 pos = now.ro + away * rd;
    View before = viewAt(iTime - iTimeDelta);
    vec3 at = pixelOf(before, pos);
    vec2 uv = (at.xy - jitter) / iResolution.xy;
    vec4 old = texture(iChannel0, uv);
    bool isSeen = at.z > 0.0 && uv == clamp(uv, 0.0, 1.0);
    bool isSame = abs(old.w - distance(pos, before.ro)) < TRUST * away;
    float share = iFrame > 0 && isSeen && isSame ? NEW_SHARE : 1.0;
    fragColor = vec4(mix(old.rgb, col, share), away);
}
