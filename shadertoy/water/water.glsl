// ---- Water ----
// Not in the seed: it names the parts of this composition only.
#define WATER_LEVEL 70.0
#define WAVE_HEIGHT 0.03

// The normal of waves that run three ways, each finer than the last. Far away they are
// smaller than a pixel, and an even surface is what is left of them.
vec3 waterNormal(vec2 p, float t) {
    vec2 slope = vec2(0.0);
    float height = WAVE_HEIGHT, frequency = 0.08;
    for (int i = 0; i < 3; i++) {
        float far = exp(-0.004 * frequency * t);
        slope += height * far * (noised(p * frequency + 0.7 * iTime).yz
            - noised(vec2(p.y, -p.x) * frequency - 0.5 * iTime).zy);
        p = m2 * p;
        frequency *= 2.7;
        height *= 0.8;
    }
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// The colour of the land, or of the sky where there is none.
vec3 landColour(vec3 ro, vec3 rd, float t) {
    if (t <= 0.0) return getSky(rd);
    vec3 pos = ro + t * rd;
    vec3 nor = calcNormal(pos, t);
    float sha = calcShadow(pos + nor * 0.5, SUN_DIR);
    return getMaterial(pos, nor) * calcLighting(pos, nor, rd, sha);
}

// The water's colour where a ray meets it after tWater units, and the land below after t.
vec3 waterColour(vec3 ro, vec3 rd, float tWater, float t) {
    vec3 pos = ro + tWater * rd;
    vec3 nor = waterNormal(pos.xz, tWater);
    // Light that comes out of the water has lost its red first.
    float deep = t > 0.0 ? t - tWater : 200.0;
    vec3 clear = exp(-deep * vec3(0.14, 0.06, 0.05));
    vec3 bottom = t > 0.0 ? landColour(ro, rd, t) : vec3(0.0);
    vec3 below = mix(vec3(0.01, 0.05, 0.06), bottom, clear);
    vec3 mirrored = reflect(rd, nor);
    mirrored.y = abs(mirrored.y) + 0.001;
    float tMirrored = raymarch(pos + vec3(0.0, 0.1, 0.0), mirrored);
    vec3 above = landColour(pos, mirrored, tMirrored);
    float fresnel = 0.02 + 0.98 * pow(1.0 - clamp(dot(nor, -rd), 0.0, 1.0), 5.0);
    float glint = pow(clamp(dot(mirrored, SUN_DIR), 0.0, 1.0), 300.0);
    return mix(below, above, fresnel) + SUN_COL * 0.15 * glint;
}
