// Not in the seed: its mainImage with the sky's slab of clouds over the sky, and the
// light shafts over all.
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = iTime * 0.5;
    vec3 ro = cameraPath(time);
    ro.y = min(terrainL(ro.xz) + CAM_ALTITUDE + 30.0, CLOUD_BASE - 20.0);
    vec3 ta = cameraPath(time + 2.0);
    // The sun stays in view, for the shafts to be seen against it.
    ta = vec3(ta.x, ro.y + 10.0, ta.z) + 120.0 * vec3(SUN_DIR.x, 0.0, SUN_DIR.z);
    mat3 cam = setCamera(ro, ta);
    vec3 rd = cam * normalize(vec3(uv, 1.5));
    float dither = fract(52.9829189 * fract(dot(fragCoord, vec2(0.06711056, 0.00583715))));
    float t = raymarch(ro, rd);
    float tAir = 1500.0;
    vec3 col;
    if (t > 0.0) {
        vec3 pos = ro + t * rd;
        vec3 nor = calcNormal(pos, t);
        vec3 mate = getMaterial(pos, nor);
        float sha = calcShadow(pos + nor * 0.5, SUN_DIR) * cloudLight(pos);
        col = mate * calcLighting(pos, nor, rd, sha);
        col = applyFog(col, t, rd);
        tAir = min(tAir, t);
    } else {
        // Both are composited front to back: the clouds' colour comes with its alpha.
        vec4 clouds = cloudSlab(ro, rd, dither);
        col = getSky(rd) * (1.0 - clouds.a) + clouds.rgb;
        if (rd.y > 0.0) tAir = min(tAir, (CLOUD_BASE - ro.y) / rd.y);
    }
    col = lightShafts(col, ro, rd, tAir, dither);
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
