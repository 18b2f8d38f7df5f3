// Not in the seed, which shows this landscape as a picture only.
void main() {
    vec2 uv = gl_FragCoord.xy / uResolution;
    uv -= 0.5;
    uv.x *= uResolution.x / uResolution.y;
    vec3 ro = vec3(2.0 * uTime, 0.0, -4.0 * uTime);
    // The eye follows the land loosely: a mean of what lies around.
    ro.y = 8.0 + 0.25 * (land(ro.xz + vec2(14.0, 0.0)) + land(ro.xz - vec2(14.0, 0.0))
        + land(ro.xz + vec2(0.0, 14.0)) + land(ro.xz - vec2(0.0, 14.0)));
    vec3 rd = setCamera(ro, ro + vec3(0.2, -0.12, -1.0)) * normalize(vec3(uv, 1.0));
    float t = raymarch(ro, rd);
    if (t > MAX_DIST) t = -1.0;
    // Behind the dust the sky is dark, but for the sun.
    vec3 color = vec3(0.10, 0.06, 0.05) + vec3(1.6, 1.5, 1.4) * smoothstep(0.9994, 0.9998, dot(rd, lightPosition));
    if (t > 0.0) {
        vec3 p = ro + rd * t;
        vec3 normal = getNormalAt(p, t);
        float diffuse = max(dot(normal, lightPosition), 0.0);
        float shadow = softShadows(p + 0.1 * normal, lightPosition, 0.2, 24.0, 10.0);
        vec3 rock = mix(vec3(0.20, 0.09, 0.06), vec3(0.36, 0.16, 0.08), smoothstep(0.6, 0.95, normal.y));
        color = rock * (3.4 * diffuse * shadow * vec3(1.0, 0.84, 0.70)
            + (0.6 + 0.4 * normal.y) * vec3(0.40, 0.26, 0.20));
    }
    color = scatter(ro, rd, color, t > 0.0 ? t : 4.0 * MAX_DIST);
    gl_FragColor = vec4(pow(1.0 - exp(-1.7 * color), vec3(1.0 / 2.2)), 1.0);
}
