// Not in the seed: a low camera over the waves, whose crests are hit from the side, and a ball
// for its other distance, which needs no shrinking.
const vec3 sunDir = vec3(0.55, 0.45, 0.70);

vec3 sky(vec3 rd) {
    vec3 col = mix(vec3(0.95, 0.70, 0.50), vec3(0.25, 0.38, 0.62), smoothstep(-0.05, 0.45, rd.y));
    return col + vec3(0.8, 0.5, 0.2) * pow(max(dot(rd, sunDir), 0.0), 60.0);
}

float ballAlong(vec3 ro, vec3 rd, vec3 centre) {
    float t = 0.0;
    for (int i = 0; i < 80 && t < MAX_DIST; i++) {
        float d = distSphere(ro + t * rd - centre, 0.7);
        if (d < 0.001) return t;
        t += d;
    }
    return -1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 ro = vec3(0.0, 3.2, 0.9 * iTime);
    vec3 rd = normalize(vec3(uv.x, uv.y - 0.25, 1.5));
    vec3 centre = vec3(1.6, 2.9 + 0.2 * sin(iTime), ro.z + 6.0);
    float t = raymarch(ro, rd);
    float tBall = ballAlong(ro, rd, centre);
    vec3 col = sky(rd);
    bool isBall = tBall > 0.0 && (t < 0.0 || tBall < t);
    if (isBall) t = tBall;
    if (t > 0.0) {
        vec3 pos = ro + t * rd;
        float eps = 0.001 + 0.0008 * t;
        vec3 nor = normalize(vec3(h(pos.xz + vec2(eps, 0.0)) - h(pos.xz - vec2(eps, 0.0)),
            2.0 * eps, h(pos.xz + vec2(0.0, eps)) - h(pos.xz - vec2(0.0, eps))));
        vec3 mate = mix(vec3(0.10, 0.16, 0.22), vec3(0.75, 0.55, 0.38), -h(pos.xz) / HEIGHT / 1.8);
        if (isBall) {
            nor = normalize(pos - centre);
            mate = vec3(0.75, 0.16, 0.10);
        }
        // The sun is met by the same march as the eye.
        vec3 from = pos + 0.02 * nor;
        bool isDark = raymarch(from, sunDir) > 0.0 || (!isBall && ballAlong(from, sunDir, centre) > 0.0);
        float sha = isDark ? 0.0 : 1.0;
        float dif = max(dot(nor, sunDir), 0.0);
        vec3 lin = 2.4 * sha * dif * vec3(1.0, 0.8, 0.6) + (0.6 + 0.4 * nor.y) * vec3(0.25, 0.32, 0.45);
        col = mix(sky(vec3(rd.x, 0.0, rd.z)), mate * lin, exp(-0.0012 * t * t));
    }
    fragColor = vec4(pow(1.0 - exp(-1.6 * col), vec3(1.0 / 2.2)), 1.0);
}
