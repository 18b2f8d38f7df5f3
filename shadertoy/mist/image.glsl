// Not in the seed: its mainImage with the fog that the ray passes added before the tone curve.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = iTime * 0.5;
    vec3 ro = cameraPath(time);
    ro.y = terrainL(ro.xz) + CAM_ALTITUDE + 30.0;
    vec3 ta = cameraPath(time + 2.0);
    ta.y = terrainL(ta.xz) + CAM_ALTITUDE;
    vec3 rd = setCamera(ro, ta) * normalize(vec3(uv, 1.5));
    float t = raymarch(ro, rd);
    vec3 col;
    if (t > 0.0) {
        vec3 pos = ro + t * rd;
        vec3 nor = calcNormal(pos, t);
        float sha = calcShadow(pos + nor * 0.5, SUN_DIR);
        col = getMaterial(pos, nor) * calcLighting(pos, nor, rd, sha);
        col = applyFog(col, t, rd);
    } else {
        col = getSky(rd);
    }
    float random = DITHER == 1 ? hash(fragCoord) : 0.5;
    col = applyMist(col, ro, rd, t > 0.0 ? min(t, FOG_REACH) : FOG_REACH, random);
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
