// Not in the seed, which names another author's function for this: what dusty air adds on the
// way of a ray. Dust takes light away exponentially, as the seed's fog does, and is thinner
// higher up. What it takes comes back: rust-red from everywhere, and bluish close around the sun,
// because dust throws blue light forward.
#define DUST 0.010
#define DUST_HEIGHT 26.0
vec3 dustLight(vec3 rd) {
    float toSun = max(dot(rd, lightPosition), 0.0);
    vec3 light = vec3(0.50, 0.27, 0.15) * (0.55 + 0.45 * toSun);
    light += vec3(0.85, 0.48, 0.26) * pow(toSun, 6.0);
    return light + vec3(0.50, 0.58, 0.66) * pow(toSun, 60.0);
}

// How much dust lies on the first d units of a ray.
float dustAlong(vec3 ro, vec3 rd, float d) {
    float rise = rd.y / DUST_HEIGHT;
    float reach = abs(rise) < 1e-4 ? d : (1.0 - exp(-d * rise)) / rise;
    return DUST * exp(-ro.y / DUST_HEIGHT) * reach;
}

vec3 scatter(vec3 ro, vec3 rd, vec3 color, float d) {
    float clear = exp(-dustAlong(ro, rd, d));
    return mix(dustLight(rd), color, clear);
}
