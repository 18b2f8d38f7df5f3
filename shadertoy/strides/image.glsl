// The parts of a picture, by the names that the seed gives them; how they are filled is not in
// the seed.
const vec3 sunDir = vec3(0.68, 0.42, 0.60);
const vec3 hazeColour = vec3(0.62, 0.70, 0.80);

vec3 getNormal(vec3 p, float t) {
    float eps = 0.002 + 0.001 * t;
    return normalize(vec3(f(p.x - eps, p.z) - f(p.x + eps, p.z), 2.0 * eps,
        f(p.x, p.z - eps) - f(p.x, p.z + eps)));
}

vec3 getMaterial(vec3 p, vec3 n) {
    vec3 rock = mix(vec3(0.22, 0.18, 0.15), vec3(0.36, 0.29, 0.22), noise(3.0 * p.xz));
    vec3 grass = vec3(0.16, 0.19, 0.06);
    vec3 col = mix(rock, grass, smoothstep(0.70, 0.90, n.y));
    float snow = smoothstep(0.52, 0.66, p.y / TERRAIN_HEIGHT + 0.1 * noise(2.0 * p.xz));
    return mix(col, vec3(0.80), snow * smoothstep(0.55, 0.75, n.y));
}

// A shadow ray is cast with the same march.
vec3 getShading(vec3 p, vec3 n) {
    float unused;
    bool isDark = castRay(p + 0.04 * n, sunDir, unused);
    float sun = isDark ? 0.0 : max(dot(n, sunDir), 0.0);
    return 2.2 * sun * vec3(1.0, 0.86, 0.68) + (0.5 + 0.5 * n.y) * vec3(0.26, 0.33, 0.44);
}

vec3 applyFog(vec3 col, float t) {
    return mix(hazeColour, col, exp(-0.0016 * t * t));
}

vec3 skyColor(vec3 rd) {
    vec3 col = mix(hazeColour, vec3(0.22, 0.40, 0.72), pow(max(rd.y, 0.0), 0.6));
    return col + vec3(0.9, 0.6, 0.3) * pow(max(dot(rd, sunDir), 0.0), 40.0);
}

vec3 terrainColor(vec3 ro, vec3 rd, float t) {
    vec3 p = ro + rd * t;
    vec3 n = getNormal(p, t);
    vec3 s = getShading(p, n);
    vec3 m = getMaterial(p, n);
    return applyFog(m * s, t);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 ro = vec3(3.0 + 0.4 * iTime, 3.1, 0.7 * iTime);
    vec3 rd = normalize(vec3(uv.x + 0.3, uv.y - 0.28, 1.4));
    float t;
    vec3 col;
    if (castRay(ro, rd, t)) {
        col = terrainColor(ro, rd, t);
    } else {
        t = -1.0;
        col = skyColor(rd);
    }
    fragColor = vec4(pow(1.0 - exp(-1.5 * col), vec3(1.0 / 2.2)), 1.0);
}
