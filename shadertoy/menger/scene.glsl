float sdCross( in vec3 p ) {
    float da = sdBox(p.xyz,vec3(inf,1.0,1.0));
    float db = sdBox(p.yzx,vec3(1.0,inf,1.0));
    float dc = sdBox(p.zxy,vec3(1.0,1.0,inf));
    return min(da,min(db,dc));
}

float scene(vec3 p) {
    float d = sdBox(p,vec3(6.0));
    float c = sdCross(p);

    float distance = max(d,c);
    return distance;
}
#undef scene

// Not in the seed, which describes it. The seed's `max(d,c)` above is what box and cross have
// in common, the bars alone; holes are what the box has and the cross has not.
#define ITERATIONS 4
float sponge(vec3 p) {
    float d = sdBox(p, vec3(6.0));
    float cell = 12.0;
    for (int i = 0; i < ITERATIONS; i++) {
        // The cross is 2 wide, and a hole a third of its cell.
        vec3 q = repeat(p + 0.5 * cell, cell) * (6.0 / cell);
        d = max(d, -sdCross(q) * (cell / 6.0));
        cell /= 3.0;
    }
    return d;
}
float scene(vec3 p) {
#if ITERATIONS == 0
    return crossInBox(p);
#else
    return sponge(p);
#endif
}
#undef EYE
#define EYE vec3(19.0 * sin(0.15 * uTime + 0.6), 8.0, 19.0 * cos(0.15 * uTime + 0.6))
#undef AIM
#define AIM vec3(0.0, -1.3, 0.0)
#undef PAINT
#define PAINT vec3(0.80, 0.62, 0.42)
