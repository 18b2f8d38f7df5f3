// Not in the seed: its mainImage with a plane of water, which a ray meets before the land
// where the land is under water.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = iTime * 0.2;
    vec3 ro = cameraPath(time);
    ro.y = max(terrainL(ro.xz), WATER_LEVEL) + CAM_ALTITUDE;
    vec3 ta = cameraPath(time + 2.0);
    ta.y = WATER_LEVEL + CAM_ALTITUDE * 0.5;
    vec3 rd = setCamera(ro, ta) * normalize(vec3(uv, 1.5));
    float t = raymarch(ro, rd);
    float tWater = rd.y < 0.0 ? (WATER_LEVEL - ro.y) / rd.y : -1.0;
    bool isWater = tWater > 0.0 && tWater < MAX_DIST && (t <= 0.0 || tWater < t);
    vec3 col;
    if (isWater) {
        col = waterColour(ro, rd, tWater, t);
        t = tWater;
    } else {
        col = landColour(ro, rd, t);
    }
    if (t > 0.0) col = applyFog(col, t, rd);
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
