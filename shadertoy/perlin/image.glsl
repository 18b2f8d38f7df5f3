// Not in the seed: a picture of a landscape under a light that wanders, as the seed's does.
void main() {
    vec2 uv = gl_FragCoord.xy / uResolution;
    uv -= 0.5;
    uv.x *= uResolution.x / uResolution.y;
    vec3 ro = EYE;
    vec3 rd = setCamera(ro, AIM) * normalize(vec3(uv, 1.0));
    float t = raymarch(ro, rd);
    if (t > MAX_DIST) t = -1.0;
    vec3 sky = SKY * (1.0 - 0.4 * max(rd.y, 0.0));
    vec3 color = sky;
    if (t > 0.0) {
        vec3 p = ro + rd * t;
        vec3 normal = getNormalAt(p, t);
        vec3 lightDirection = normalize(vec3(cos(0.2 * uTime), 0.5, 0.7 * sin(0.2 * uTime)));
        float diffuse = max(dot(normal, lightDirection), 0.0);
        float shadow = softShadows(p + 0.05 * normal, lightDirection, 0.1, 6.0, 10.0);
        vec3 lit = 2.4 * diffuse * shadow * vec3(1.0, 0.86, 0.70)
            + (0.5 + 0.5 * normal.y) * vec3(0.30, 0.36, 0.46);
        color = mix(sky, PAINT * lit, exp(-4.0 * t * t / (MAX_DIST * MAX_DIST)));
    }
    gl_FragColor = vec4(sqrt(color), 1.0);
}
