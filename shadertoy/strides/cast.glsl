// The three ways of stepping that the seed describes. Its own code is lost: the document
// was copied without the listings, and only speaks of mint, maxt and delt.
#define STEP 0.05
#define MIN_DIST 0.01
#define MAX_DIST 40.0
#define INTERPOLATE 1
// By how much a step grows with each unit of distance; 0.0 keeps them even.
#define STEP_GROWTH 0.01

// Goes forward until a point lies below the ground. Where exactly the ray went under is then
// either in the middle of the last step, or where a straight ground would be met.
bool castRay(vec3 ro, vec3 rd, out float resT) {
    float delt = STEP;
    const float mint = MIN_DIST, maxt = MAX_DIST;
    float lastHeight = 0.0, lastY = 0.0;
    for (float t = mint; t < maxt; t += delt) {
        vec3 p = ro + t * rd;
        float height = f(p.x, p.z);
        if (p.y < height) {
#if INTERPOLATE
            // How far above the ground the last point was, and how far below it this one is.
            float above = lastY - lastHeight, below = height - p.y;
            resT = t == mint ? t : t - delt * below / (above + below);
#else
            resT = t == mint ? t : t - 0.5 * delt;
#endif
            return true;
        }
        lastHeight = height;
        lastY = p.y;
        // Detail shrinks on the screen as it goes away, and an error with it.
        delt = STEP + STEP_GROWTH * t;
    }
    return false;
}
