#define scene united
float scene(vec3 p) {
    float plane = p.y;
    float sphere = sdSphere(p, 1.0);

    float distance = min(sphere, plane);
    return distance;
}
#undef scene

// Not in the seed: which of its operations is shown, and a second ball to cut the first by.
#define OPERATION 0
#define SMOOTHNESS 0.6
float scene(vec3 p) {
#if OPERATION == 0
    return united(p);
#elif OPERATION == 1
    vec3 aside = vec3(0.6, 0.3, 0.3);
    float ball = max(sdSphere(p - aside - vec3(0.0, 0.6, 0.0), 1.0), sdSphere(p + aside - vec3(0.0, 0.6, 0.0), 1.0));
    return min(ball, p.y);
#else
    return smoothmin(sdSphere(p - vec3(0.0, 0.3, 0.0), 1.0), p.y, SMOOTHNESS);
#endif
}

#undef EYE
#define EYE vec3(1.2, 2.0, 3.6)
#undef AIM
#define AIM vec3(0.0, 0.3, 0.0)
// Squares tell where the plane is.
#undef PAINT
#define PAINT (p.y < 0.02 ? vec3(0.26 + 0.3 * mod(floor(p.x) + floor(p.z), 2.0)) : vec3(0.85, 0.36, 0.24))
