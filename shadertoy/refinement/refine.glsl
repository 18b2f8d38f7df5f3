// ---- Binary Refinement ----
float bisect(in vec3 ro, in vec3 rd, float tNear, float tFar) {
    for (int i = 0; i < 5; i++) {
        float tMid = 0.5 * (tNear + tFar);
        vec3 pos = ro + tMid * rd;
        float h = pos.y - terrainM(pos.xz);
        if (h > 0.0) tNear = tMid; else tFar = tMid;
    }
    return 0.5 * (tNear + tFar);
}

// Not in the seed: the caller that gives bisect its bracket. raymarch stops once the
// ground is within 0.0015 * t, so its hit floats above the ground, and a ray that
// only grazes a ridge counts as a hit, which thickens every silhouette.
float raymarchRefined(in vec3 ro, in vec3 rd) {
    float t = raymarch(ro, rd);
    if (t <= 0.0) return t;

    // The last step may have ended below the ground: back off until above it.
    float tNear = t;
    float back = 0.0015 * t;
    for (int i = 0; i < 6; i++) {
        vec3 pos = ro + tNear * rd;
        if (pos.y > terrainM(pos.xz)) break;
        tNear -= back;
        back *= 2.0;
    }

    // Go on until below the ground, and bisect the step that led there. A ray that
    // grazed a ridge finds no crossing there, and marches on to what lies behind.
    for (int i = 0; i < 64; i++) {
        vec3 pos = ro + t * rd;
        float h = pos.y - terrainM(pos.xz);
        if (h < 0.0) return bisect(ro, rd, tNear, t);
        if (t > MAX_DIST || pos.y > TERRAIN_HEIGHT) return -1.0;
        tNear = t;
        t += max(STEP_FACTOR * h, 0.0005 * t);
    }
    return t;
}
// The template's mainImage now marches with refinement.
#define raymarch raymarchRefined
