// Not in the seed: marching, normals and shadows on mapCanyon, which is not a
// heightfield. They go by the names that the template's mainImage calls.
float raymarch(in vec3 ro, in vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
        vec3 pos = ro + t * rd;
        float h = mapCanyon(pos);
        if (abs(h) < 0.0004 * t) break;
        if (t > MAX_DIST || (rd.y > 0.0 && pos.y > 42.0)) return -1.0;
        t += h;
    }
    return t;
}

vec3 calcNormal(in vec3 pos, float t) {
    vec2 e = vec2(1.0, -1.0) * (0.01 + 0.0008 * t);
    return normalize(e.xyy * mapCanyon(pos + e.xyy) + e.yyx * mapCanyon(pos + e.yyx)
        + e.yxy * mapCanyon(pos + e.yxy) + e.xxx * mapCanyon(pos + e.xxx));
}

float calcShadow(in vec3 pos, in vec3 sunDir) {
    float res = 1.0, t = 0.2;
    for (int i = 0; i < SHADOW_STEPS; i++) {
        vec3 p = pos + t * sunDir;
        float h = mapCanyon(p);
        if (h < 0.001) return 0.0;
        res = min(res, SHADOW_K * h / t);
        if (p.y > 42.0) break;
        t += clamp(h, 0.2, 4.0);
    }
    return clamp(res, 0.0, 1.0);
}
