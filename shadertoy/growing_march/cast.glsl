// The seed's own march never ends unless its first point lies below the ground: it begins at
// t = 0, where a step in proportion to t is no step, and stays there. ZERO_STEP 1 takes it as
// it is, to be translated rather than drawn: a driver may hang on it.
#define ZERO_STEP 0
#define terrain landModel
#if ZERO_STEP
bool castRay(vec3 ro, vec3 rd, out float resT) {
    float dt = 0.0001;
    float lastH = terrain(ro.x, ro.z);
    float lastY = ro.y;

    for (float t = 0.; t <= 1000.; t += dt) {
        vec3 p = ro + rd * t;
        float h = terrain(p.x, p.z);
        if (p.y < h) {

            resT = t - dt + dt * (lastH - lastY) / (p.y - lastY - h + lastH);
            return true;
        }
        lastH = h;
        lastY = p.y;

        dt = 0.01 * t;
    }

    return false;
}
#else
// The same, but no step is shorter than the first.
#define STEP 0.0001
#define STEP_GROWTH 0.01
bool castRay(vec3 ro, vec3 rd, out float resT) {
    float dt = STEP;
    float lastH = terrain(ro.x, ro.z);
    float lastY = ro.y;

    for (float t = 0.; t <= 1000.; t += dt) {
        vec3 p = ro + rd * t;
        float h = terrain(p.x, p.z);
        if (p.y < h) {
            resT = t - dt + dt * (lastH - lastY) / (p.y - lastY - h + lastH);
            return true;
        }
        lastH = h;
        lastY = p.y;
        dt = max(STEP, STEP_GROWTH * t);
    }

    return false;
}
#endif
#undef terrain
