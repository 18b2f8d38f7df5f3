// ---- Relaxation Marching ----
// Not in the seed: its march gives up at t = 400, which is tuned for a world of
// smaller hills. It marches a model of the terrain at 1 : RELAX_SCALE, so that its
// 400 units reach over RELAX_SCALE * 400 units of ours.
#define RELAX_SCALE 25.0
float terrainModel(in vec2 p) {
    return terrainM(p * RELAX_SCALE) / RELAX_SCALE;
}
#define terrainM terrainModel
float raymarchRelax(in vec3 ro, in vec3 rd) {
    float t = 0.0;
    float d = (ro + rd * t).y - terrainM((ro + rd * t).xz);
    for (int i = 0; i < 90; i++) {
        if (abs(d) < t * 0.0001 || t > 400.0) break;
        float rl = max(t * 0.02, 1.0);
        t += d * rl;
        vec3 pos = ro + t * rd;
        d = (pos.y - terrainM(pos.xz)) * 0.7;
    }
    return t;
}

#undef terrainM
// Not in the seed: takes the place of the template's raymarch. A ray that ran out of
// the march's range hit nothing.
float raymarch(in vec3 ro, in vec3 rd) {
    float t = raymarchRelax(ro / RELAX_SCALE, rd);
    return t > 400.0 ? -1.0 : t * RELAX_SCALE;
}
