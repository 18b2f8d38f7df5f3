// ---- Dithered Start ----
// Not in the seed: a march that needs dithering. The template's steps shrink towards the
// ground; these have one size near the eye and grow with the distance, and the hit is
// wherever a step first ends below the ground, so that a cliff shows the steps as bands.
#define DITHER 1
#define STEP 4.0
#define STEP_GROWTH 0.012
float raymarch(in vec3 ro, in vec3 rd) {
    vec2 fragCoord = gl_FragCoord.xy;
    float step_size = STEP;
    float t = 0.0;
#if DITHER
    t += hash(fragCoord) * step_size;
#endif
    for (int i = 0; i < MAX_STEPS; i++) {
        vec3 pos = ro + t * rd;
        if (pos.y < terrainM(pos.xz)) return t;
        if (t > MAX_DIST || (rd.y > 0.0 && pos.y > TERRAIN_HEIGHT)) return -1.0;
        // Counted from the start of the ray, not from where dithering has moved it, so that
        // all steps of a ray are dithered alike.
        step_size = STEP + STEP_GROWTH * t;
        t += step_size;
    }
    return -1.0;
}
