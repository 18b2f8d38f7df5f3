// ---- Volumetric Clouds, repaired ----
// Not in the seed: its march through the slab, which stands verbatim in clouds.glsl, with its numbers as
// macros. It keeps both ends where they come in the wrong order, so that it holds from above too.
#define CLOUD_STEPS 64
#define CLOUD_GROWTH 0.05
// 1: the opacity of a step is that of its length, and finer steps make the same cloud. 0, as in the
// seed: every step adds as much, and finer steps make a thicker cloud.
#define CLOUD_OPACITY 0
vec4 marchClouds(vec3 ro, vec3 rd) {
    float base = (CLOUD_BASE - ro.y) / rd.y;
    float top = (CLOUD_TOP - ro.y) / rd.y;
    float t = max(min(base, top), 0.0), tmax = max(base, top);
    vec4 sum = vec4(0.0);
    float rays = 0.0;
    for (int i = 0; i < CLOUD_STEPS; i++) {
        if (sum.a > 0.99 || t > tmax) break;
        vec3 pos = ro + t * rd;
        float hFrac = (pos.y - CLOUD_BASE) / (CLOUD_TOP - CLOUD_BASE);
        float shape = 1.0 - 2.0 * abs(hFrac - 0.5);
        float den = shape - 1.6 * (1.0 - cloudNoise(pos.xz * 0.01));
        float dt = max(10.0 * CLOUD_GROWTH, CLOUD_GROWTH * t);
        if (den > 0.0) {
            float shadowDen = shape - 1.6 * (1.0 - cloudNoise((pos.xz + SUN_DIR.xz * 30.0) * 0.01));
            float shadow = clamp(1.0 - shadowDen * 2.0, 0.0, 1.0);
            float alpha = clamp(den * 0.4, 0.0, 1.0);
            float part = 1.0;
#if CLOUD_OPACITY
            // Of the seed's steps, which are a twentieth of t.
            part = CLOUD_GROWTH / 0.05;
            alpha = 1.0 - pow(1.0 - alpha, part);
#endif
            rays += part * 0.02 * shadow * (1.0 - sum.a);
            vec3 cloudCol = mix(vec3(0.4, 0.4, 0.45), vec3(1.0, 0.95, 0.8), shadow);
            sum += vec4(cloudCol * alpha, alpha) * (1.0 - sum.a);
        }
        t += dt;
    }
    sum.rgb += pow(rays, 3.0) * 0.4 * vec3(1.0, 0.8, 0.7);
    return sum;
}
#define SEED 0
#if SEED
#define marchClouds raymarchClouds
#endif
