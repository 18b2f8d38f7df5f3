// Not in the seed, which calls it: how much light reaches a point, by how close its ray to
// the light passes by other things, k being how sharp shadows are.
#ifndef SHADOW_STEPS
#define SHADOW_STEPS 48
#endif
float softShadows(vec3 ro, vec3 rd, float mint, float maxt, float k) {
    float light = 1.0, t = mint;
    for (int i = 0; i < SHADOW_STEPS && t < maxt; i++) {
        float gap = scene(ro + rd * t);
        if (gap < 0.001) return 0.0;
        light = min(light, k * gap / t);
        t += clamp(gap, 0.02, 0.5);
    }
    return light;
}
