// ---- Volumetric Clouds + God Rays ----
// Not in the seed: the clouds' own noise, which drifts with the wind. A single octave
// would show its grid, so here are several, spread out to leave gaps for the sun. The
// last octave's weight stands in for the mean of those left out.
float cloudFBM(vec2 p, int octaves) {
    p += vec2(0.04, 0.02) * iTime;
    float n = 0.0, a = 0.5;
    for (int i = 0; i < octaves; i++) {
        n += a * noise(p);
        a *= 0.5;
        p = m2 * p * 2.0;
    }
    return 1.8 * (n + a) - 0.36;
}
float cloudNoise(vec2 p) { return cloudFBM(p, 4); }
#define noise cloudNoise
#define CLOUD_BASE 200.0
#define CLOUD_TOP 300.0
vec4 raymarchClouds(vec3 ro, vec3 rd) {
    float tmin = (CLOUD_BASE - ro.y) / rd.y;
    float tmax = (CLOUD_TOP - ro.y) / rd.y;
    if (tmin > tmax) { float tmp = tmin; tmin = tmp; tmax = tmp; }
    if (tmin < 0.0) tmin = 0.0;
    float t = tmin;
    vec4 sum = vec4(0.0); float rays = 0.0;
    for (int i = 0; i < 64; i++) {
        if (sum.a > 0.99 || t > tmax) break;
        vec3 pos = ro + t * rd;
        float hFrac = (pos.y - CLOUD_BASE) / (CLOUD_TOP - CLOUD_BASE);
        float shape = 1.0 - 2.0 * abs(hFrac - 0.5);
        float den = shape - 1.6 * (1.0 - noise(pos.xz * 0.01));
        if (den > 0.0) {
            float shadowDen = shape - 1.6 * (1.0 - noise((pos.xz + SUN_DIR.xz * 30.0) * 0.01));
            float shadow = clamp(1.0 - shadowDen * 2.0, 0.0, 1.0);
            vec3 cloudCol = mix(vec3(0.4, 0.4, 0.45), vec3(1.0, 0.95, 0.8), shadow);
            float alpha = clamp(den * 0.4, 0.0, 1.0);
            rays += 0.02 * shadow * (1.0 - sum.a);
            cloudCol *= alpha;
            sum += vec4(cloudCol, alpha) * (1.0 - sum.a);
        }
        t += max(0.5, 0.05 * t);
    }
    sum.rgb += pow(rays, 3.0) * 0.4 * vec3(1.0, 0.8, 0.7);
    return sum;
}

#undef noise

// Not in the seed: how much sun gets through the slab to a point below it, read where
// the sun's ray crosses the slab's middle.
float cloudLight(vec3 pos) {
    float up = 0.5 * (CLOUD_BASE + CLOUD_TOP) - pos.y;
    vec2 p = pos.xz + SUN_DIR.xz * (up / SUN_DIR.y);
    float den = 1.0 - 1.6 * (1.0 - cloudFBM(p * 0.01, 2));
    return 1.0 - smoothstep(0.05, 0.3, den);
}

// Not in the seed: its god rays brighten the slab's thin places only, so the shafts
// below it are gathered here, over the ray's first tEnd units. What the hazy air takes
// from the picture comes back as skylight, and as sunlight where the slab lets it by.
vec3 lightShafts(vec3 col, vec3 ro, vec3 rd, float tEnd, float dither) {
    float lit = 0.0, clear = 1.0;
    float dt = tEnd / 28.0;
    float pass = exp(-dt * 0.0009);
    for (int i = 0; i < 28; i++) {
        float t = (float(i) + dither) * dt;
        lit += clear * (1.0 - pass) * cloudLight(ro + t * rd);
        clear *= pass;
    }
    float sundot = clamp(dot(rd, SUN_DIR), 0.0, 1.0);
    vec3 sun = vec3(1.0, 0.8, 0.55) * (0.15 + 2.0 * pow(sundot, 3.0));
    return col * clear + vec3(0.13, 0.15, 0.19) * (1.0 - clear) + sun * lit;
}

// Not in the seed: calls raymarchClouds only where it holds, from below the slab and
// upwards, and fades the slab out towards the horizon, where it is infinitely far.
vec4 cloudSlab(vec3 ro, vec3 rd, float dither) {
    if (ro.y > CLOUD_BASE || rd.y < 0.03) return vec4(0.0);
    float tmin = (CLOUD_BASE - ro.y) / rd.y;
    // The march steps by a share of its t. Moving its start most of the way to the
    // slab makes the steps small there, and a start that varies hides their layers.
    vec4 sum = raymarchClouds(ro + (0.88 + 0.02 * dither) * tmin * rd, rd);
    return sum * exp(-tmin * 0.0005) * smoothstep(0.03, 0.1, rd.y);
}
