// Not in the seed, which describes it: the eye's rays, the light, and what lies behind.
vec3 backdrop(vec2 uv) {
    return mix(vec3(0.16, 0.19, 0.27), vec3(0.62, 0.68, 0.74), smoothstep(-0.5, 0.6, uv.y + 0.2 * sin(0.3 * uTime)));
}

void main() {
    vec2 uv = gl_FragCoord.xy / uResolution;
    uv -= 0.5;
    uv.x *= uResolution.x / uResolution.y;
    vec3 ro = EYE;
    vec3 rd = setCamera(ro, AIM) * normalize(vec3(uv, 1.0));
    float t = raymarch(ro, rd);
    if (t > MAX_DIST) t = -1.0;
    vec3 color = backdrop(uv);
    if (t > 0.0) {
        vec3 p = ro + rd * t;
        vec3 lit = vec3(1.0);
#if LIGHT
        vec3 normal = getNormal(p);
        vec3 lightDirection = normalize(vec3(cos(0.5 * uTime + 0.6), 0.9, 0.35 + sin(0.5 * uTime + 0.6)));
        float diffuse = max(dot(normal, lightDirection), 0.0);
        float shadow = softShadows(p + 0.02 * normal, lightDirection, 0.05, 12.0, 12.0);
        lit = diffuse * shadow * vec3(1.0, 0.92, 0.80) + (0.5 + 0.5 * normal.y) * vec3(0.16, 0.19, 0.25);
#endif
        // What is far away fades, as the march ends there.
        color = mix(color, sqrt(PAINT * lit), exp(-0.0011 * t * t));
    }
    gl_FragColor = vec4(color, 1.0);
}
