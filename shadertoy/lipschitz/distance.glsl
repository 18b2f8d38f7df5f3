// The seed's own text is no GLSL: it has no types of results, and `mag` for `length`.
#if 0
function distSphere(vec3 pos, float r) {
    return mag(pos) - r;
}
function distHeightfield(vec3 pos) {
    return h(pos.xz) + pos.y;
}
#endif
float distSphere(vec3 pos, float r) {
    return length(pos) - r;
}
float distHeightfield(vec3 pos) {
    return h(pos.xz) + pos.y;
}

// With SHRINK 0 a step is as long as the ground is far below, and passes through crests beside
// it. With SHRINK 1 no step can.
#define SHRINK 1
#if SHRINK
const float shrinkFactor = 1.0 / sqrt(1.0 + STEEPEST * STEEPEST);
#else
const float shrinkFactor = 1.0;
#endif

#define MAX_STEPS 300
#define MAX_DIST 60.0
float raymarch(vec3 ro, vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
        float d = distHeightfield(ro + t * rd);
        if (d < 0.0005 * t) return t;
        t += d * shrinkFactor;
        if (t > MAX_DIST) return -1.0;
    }
    return t;
}
