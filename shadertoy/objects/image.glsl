// Not in the seed: its mainImage with another normal and colour where a stone was met.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = 8.0 + iTime * 0.15;
    vec3 ro = cameraPath(time);
    ro.y = terrainL(ro.xz) + CAM_ALTITUDE;
    vec3 ta = cameraPath(time + 1.0);
    ta.y = terrainL(ta.xz) + 12.0;
    vec3 rd = setCamera(ro, ta) * normalize(vec3(uv, 1.5));
    float t = raymarch(ro, rd);
    vec3 col;
    if (t > 0.0) {
        vec3 pos = ro + t * rd;
        bool isStone = stone(pos) < STEP_FACTOR * (pos.y - terrainM(pos.xz));
        vec3 nor = isStone ? stoneNormal(pos) : calcNormal(pos, t);
        vec3 mate = isStone
            ? vec3(0.16, 0.15, 0.14) * (0.6 + 0.8 * noise(2.0 * pos.xz + pos.y))
            : getMaterial(pos, nor);
        float sha = calcShadow(pos + nor * 0.5, SUN_DIR) * stoneShadow(pos + nor * 0.1, SUN_DIR);
        col = mate * calcLighting(pos, nor, rd, sha);
        col = applyFog(col, t, rd);
    } else {
        col = getSky(rd);
    }
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
