// ---- Volumetric Fog ----
// Not in the seed: it names the parts of this composition only.
#define FOG_STEPS 40
#define FOG_OCTAVES 3
#define FOG_REACH 1200.0
#define FOG_TOP 95.0
#define FOG_THICKNESS 0.009
#define DITHER 1

// Noise in three dimensions, out of layers of the flat one.
float noise3(vec3 p) {
    float layer = floor(p.y), f = p.y - layer;
    f = f * f * (3.0 - 2.0 * f);
    vec2 shift = vec2(37.0, 17.0);
    return mix(noise(p.xz + shift * layer), noise(p.xz + shift * (layer + 1.0)), f);
}

// How thick the fog is at a point: dense low down, torn into banks, gone above FOG_TOP.
float fogDensity(vec3 p) {
    float low = 1.0 - smoothstep(0.3 * FOG_TOP, FOG_TOP, p.y);
    if (low <= 0.0) return 0.0;
    vec3 q = vec3(0.014, 0.03, 0.014) * p + vec3(0.12, 0.0, 0.05) * iTime;
    float n = 0.0, a = 0.5;
    for (int i = 0; i < FOG_OCTAVES; i++) {
        n += a * noise3(q);
        q *= 2.03;
        a *= 0.5;
    }
    return low * smoothstep(0.36, 0.62, n);
}

// The picture behind the fog that a ray has passed on its first tEnd units. Steps grow with
// the distance, as what is far away needs fewer; a random start hides their layers.
vec3 applyMist(vec3 col, vec3 ro, vec3 rd, float tEnd, float random) {
    float clear = 1.0;
    vec3 lit = vec3(0.0);
    float growth = pow(tEnd / 4.0, 1.0 / float(FOG_STEPS));
    float last = 0.0, next = 4.0;
    for (int i = 0; i < FOG_STEPS && clear > 0.01; i++) {
        float t = mix(last, next, random);
        vec3 p = ro + t * rd;
        float density = FOG_THICKNESS * fogDensity(p);
        if (density > 0.0) {
            // Less fog towards the sun means more of its light.
            float shade = fogDensity(p + 14.0 * SUN_DIR);
            float sun = pow(0.5 + 0.5 * dot(rd, SUN_DIR), 4.0);
            vec3 light = vec3(0.36, 0.42, 0.50) + vec3(0.55, 0.40, 0.25) * (0.3 + sun) * (1.0 - 0.8 * shade);
            float pass = exp(-density * (next - last));
            lit += clear * (1.0 - pass) * light;
            clear *= pass;
        }
        last = next;
        next *= growth;
    }
    return col * clear + lit;
}
