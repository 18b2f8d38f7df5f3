// Not in the seed: its mainImage with another eye, which looks level ahead. It stands CAM_ALTITUDE
// above the ground that is marched through; the seed's stands above the ground's first three octaves.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = iTime * 0.5;
    vec3 ro = cameraPath(time);
    ro.y = terrainM(ro.xz) + CAM_ALTITUDE;
    vec3 ta = cameraPath(time + 2.0);
    ta.y = ro.y;
    mat3 cam = setCamera(ro, ta);
    vec3 rd = cam * normalize(vec3(uv, 1.5));
    float t = raymarch(ro, rd);
    vec3 col = getSky(rd);
    if (t > 0.0) {
        vec3 pos = ro + t * rd;
        vec3 nor = calcNormal(pos, t);
        vec3 mate = getMaterial(pos, nor);
        float sha = calcShadow(pos + nor * 0.5, SUN_DIR);
        col = applyFog(mate * calcLighting(pos, nor, rd, sha), t, rd);
    }
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
