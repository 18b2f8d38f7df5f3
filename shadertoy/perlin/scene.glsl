#define scene ground
#pragma glslify: cnoise = require(glsl-noise/classic/2d)

#define PI 3.14159265359

mat2 rotate2D(float a) {
    float sa = sin(a);
    float ca = cos(a);
    return mat2(ca, -sa, sa, ca);
}

float fbm(vec2 p) {
    float res = 0.0;
    float amp = 0.8;
    float freq = 1.5;

    for(int i = 0; i < 12; i++) {
        res += amp * cnoise(p * 0.8);
        amp *= 0.5;
        freq *= 1.05;
        p = p * freq * rotate2D(PI / 4.0);
    }
    return res;
}

float scene(vec3 p) {
    float distance = 0.0;
    distance += fbm(p.xz * 0.3);
    distance += p.y + 2.0;

    return distance;
}
#undef scene

// Not in the seed: it takes the height above the ground for the distance, which oversteps
// where the ground is steep.
#define STEP_FACTOR 0.55
float scene(vec3 p) {
    return STEP_FACTOR * ground(p);
}
#undef MAX_STEPS
#define MAX_STEPS 180
#undef MAX_DIST
#define MAX_DIST 26.0
#undef EYE
#define EYE vec3(0.3 * uTime, 0.1, -0.5 * uTime)
#undef AIM
#define AIM (ro + vec3(0.1, -0.2, -1.0))
#undef PAINT
#define PAINT mix(vec3(0.10, 0.08, 0.07), vec3(0.16, 0.15, 0.12), smoothstep(0.5, 0.9, normal.y))
#define SKY vec3(0.60, 0.68, 0.78)
