// ---- Directional Erosion Noise ----
// Not in the seed: a hash of two independent values in 0.5..1.5. erosionNoise sums the
// cells from -2 to 1 only, and points in that range keep equally far from either end,
// where a cell leaves the sum at once and too heavy a one would leave a seam.
vec2 hash2(vec2 p) {
    vec3 p3 = fract(vec3(p.xyx) * vec3(0.1031, 0.1030, 0.0973));
    p3 += dot(p3, p3.yzx + 33.33);
    return 0.5 + fract((p3.xx + p3.yz) * p3.zy);
}
#define EROSION_BRANCH 1.5
vec3 erosionNoise(vec2 p, vec2 dir) {
    vec2 ip = floor(p); vec2 fp = fract(p) - 0.5;
    float va = 0.0, wt = 0.0; vec2 dva = vec2(0.0);
    for (int i = -2; i <= 1; i++)
        for (int j = -2; j <= 1; j++) {
        vec2 o = vec2(float(i), float(j));
        vec2 h = hash2(ip - o) * 0.5;
        vec2 pp = fp + o + h;
        float d = dot(pp, pp);
        float w = exp(-d * 2.0);
        float mag = dot(pp, dir);
        va += cos(mag * 6.283) * w;
        dva += -sin(mag * 6.283) * dir * w;
        wt += w;
    }
    return vec3(va, dva) / wt;
}
float terrainErosion(vec2 p, vec2 baseSlope) {
    float e = 0.0, a = 0.5;
    vec2 dir = normalize(baseSlope + vec2(0.001));
    for (int i = 0; i < 5; i++) {
        vec3 n = erosionNoise(p * 4.0, dir);
        e += a * n.x;
        dir = normalize(dir + n.zy * vec2(1.0, -1.0) * EROSION_BRANCH);
        a *= 0.5; p *= 2.0;
    }
    return e;
}

// Not in the seed: how the erosion lies on the terrain.
#define EROSION_DEPTH 14.0 // Half the height between gully floor and crest
#define EROSION_SCALE 0.004 // Spatial frequency of the largest gullies, times four

// The land before the rain: broad forms only, all detail is left to the erosion.
float terrainBase(vec2 p) { return terrainFBM(p, 4); }

float terrainEroded(vec2 p) {
    float h = terrainBase(p);
    vec2 slope = vec2(terrainBase(p + vec2(6.0, 0.0)), terrainBase(p + vec2(0.0, 6.0))) - h;
    slope /= 6.0;
    // The waves run along the direction they are given, so they get the contour's:
    // crest then follows gully across the slope, and each runs straight down it.
    vec2 contour = vec2(slope.y, -slope.x);
    float steep = smoothstep(0.02, 0.35, length(slope));
    return h + EROSION_DEPTH * steep * terrainErosion(p * EROSION_SCALE, contour);
}

// The levels of detail. Shadows are looked up in the middle one: the gullies' floor,
// so that no slope lies in the shadow of itself.
float terrainL(vec2 p) { return terrainFBM(p, 3); }
float terrainM(vec2 p) { return terrainBase(p) - EROSION_DEPTH; }
float terrainH(vec2 p) { return terrainEroded(p); }
