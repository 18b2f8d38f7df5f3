// Not in the seed, which describes it: three balls on ways of their own. The ripples make
// the distance steeper than it is, which a shorter step makes good.
#define SMOOTHNESS 0.8
#define RIPPLES 0.10
#define STEP_FACTOR 0.7
float scene(vec3 p) {
    vec3 a = vec3(1.3 * sin(0.9 * uTime), 0.5 * cos(0.7 * uTime), 0.3);
    vec3 b = vec3(1.2 * cos(0.8 * uTime + 1.0), 0.8 * sin(1.1 * uTime), -0.3);
    vec3 c = vec3(0.4 * sin(0.5 * uTime), -0.9 * sin(0.6 * uTime + 0.5), 0.5);
    float d = smoothmin(sdSphere(p - a, 0.85), sdSphere(p - b, 0.7), SMOOTHNESS);
    d = smoothmin(d, sdSphere(p - c, 0.75), SMOOTHNESS);
    if (d > 0.5) return d - RIPPLES;
    float ripple = cnoise(2.2 * p.xy + 0.6 * uTime) + cnoise(2.2 * p.yz - 0.5 * uTime);
    return STEP_FACTOR * (d + 0.5 * RIPPLES * ripple);
}
#undef EYE
#define EYE vec3(0.0, 0.6, 4.0)
#undef PAINT
#define PAINT (0.55 + 0.35 * cos(vec3(0.0, 1.4, 2.6) + 1.3 * p.y + 0.8 * p.x))
