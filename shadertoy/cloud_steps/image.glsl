// Not in the seed: its mainImage with clouds alone. HORIZON 1 has none near the horizon, where the slab is
// infinitely far, and lets them fade in above it, as the scene of the seed's clouds does.
#define EYE_HEIGHT 150.0
#define LOOK_UP 90.0
#define LENS 1.5
#define HORIZON 1
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float time = iTime * 0.5;
    vec3 ro = cameraPath(time);
    ro.y = EYE_HEIGHT;
    vec3 ta = cameraPath(time + 2.0);
    ta.y = ro.y + LOOK_UP;
    vec3 rd = setCamera(ro, ta) * normalize(vec3(uv, LENS));
#if HORIZON
    vec4 clouds = vec4(0.0);
    if (rd.y > 0.03) clouds = marchClouds(ro, rd) * smoothstep(0.03, 0.1, rd.y);
#else
    vec4 clouds = marchClouds(ro, rd);
#endif
    vec3 col = getSky(rd) * (1.0 - clouds.a) + clouds.rgb;
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
