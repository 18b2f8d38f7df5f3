// Not in the seed: the template's picture in parts, so that two moments of the flight can be compared.
struct View {
    vec3 ro;
    mat3 cam;
};

View viewAt(float seconds) {
    float time = seconds * 0.5;
    vec3 ro = cameraPath(time);
    ro.y = terrainL(ro.xz) + CAM_ALTITUDE;
    vec3 ta = cameraPath(time + 2.0);
    ta.y = terrainL(ta.xz) + CAM_ALTITUDE * 0.5;
    return View(ro, setCamera(ro, ta));
}

const float LENS = 1.5;

vec3 rayThrough(View view, vec2 pixel) {
    vec2 uv = (2.0 * pixel - iResolution.xy) / iResolution.y;
    return view.cam * normalize(vec3(uv, LENS));
}

// The pixel in which a view sees a point, and how far behind the lens the point lies.
vec3 pixelOf(View view, vec3 pos) {
    vec3 seen = (pos - view.ro) * view.cam;
    return vec3((LENS * seen.xy / seen.z * iResolution.y + iResolution.xy) * 0.5, seen.z);
}

vec3 shade(vec3 ro, vec3 rd, float t) {
    if (t <= 0.0) return getSky(rd);
    vec3 pos = ro + t * rd;
    vec3 nor = calcNormal(pos, t);
    vec3 mate = getMaterial(pos, nor);
    float sha = calcShadow(pos + nor * 0.5, SUN_DIR);
    vec3 lin = calcLighting(pos, nor, rd, sha);
    return applyFog(mate * lin, t, rd);
}

// Light as a display shows it.
vec3 display(vec3 col) {
    col = 1.0 - exp(-col * 2.0);
    return pow(col, vec3(1.0 / 2.2));
}
