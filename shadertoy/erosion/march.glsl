// ---- Ray Marching ----
// Not in the seed: takes the place of the template's raymarch. One eroded height costs
// many times what a plain one does, so a ray asks for it only within the erosion's reach
// of the land below it.
float raymarch(in vec3 ro, in vec3 rd) {
    float t = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
        vec3 pos = ro + t * rd;
        float h = pos.y - terrainBase(pos.xz);
        if (h < 0.85 * EROSION_DEPTH) {
            h = pos.y - terrainEroded(pos.xz);
            if (abs(h) < 0.002 * t) break;
        }
        if (t > MAX_DIST || (rd.y > 0.0 && pos.y > 2.0 * TERRAIN_HEIGHT)) return -1.0;
        t += STEP_FACTOR * h;
    }
    return t;
}
