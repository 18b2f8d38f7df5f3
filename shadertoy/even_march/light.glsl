// Not in the seed, which calls it and shows none: the colour of a point of the model. The
// material blends by heights from -100, where rock begins, to -60, where there is no more
// grass, so that the land's own heights are put on that scale.
#define FOG_DENSITY 0.07
#define FOG_FALLOFF 2.0
const vec3 toSun = vec3(0.74, 0.45, 0.50);

vec3 computeShadingForPoint(vec3 p) {
    p *= MODEL_SCALE;
    float eps = 0.002 * length(p - MODEL_SCALE * eye) + 0.002;
    float here = land(p.x, p.z);
    vec3 n = normalize(vec3(here - land(p.x + eps, p.z), eps, here - land(p.x, p.z + eps)));
    vec3 q = vec3(4.0 * p.x, mix(-115.0, -35.0, p.y / (0.75 * TERRAIN_HEIGHT)), 4.0 * p.z);
    vec3 colour = material(q, n);
    float shade = 1.0;
    for (float t = 0.1; t < 2.0; t += 0.1) {
        vec3 way = p + t * toSun;
        shade = min(shade, 0.5 + 4.0 * (way.y - land(way.x, way.z)) / t);
    }
    float sun = max(dot(n, toSun), 0.0) * clamp(shade, 0.0, 1.0);
    return colour * (0.55 * sun * vec3(1.0, 0.9, 0.72) + (0.6 + 0.4 * n.y) * vec3(0.10, 0.13, 0.19));
}

// The seed's exponential squared fog: the factor by which a colour is left.
float fogFactor(float dist) {
    return exp(-pow(dist * FOG_DENSITY, FOG_FALLOFF));
}
