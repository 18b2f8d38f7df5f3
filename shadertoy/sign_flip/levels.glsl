// ---- Sign-Alternating FBM ----
float terrainSignFlip(in vec2 p) {
    p *= TERRAIN_SCALE;
    float a = 0.0, w = 1.0;
    for (int i = 0; i < TERRAIN_OCTAVES; i++) {
        a += w * noise(p);
        w = -w * 0.4;
        p = m2 * p * 2.0;
    }
    return a * TERRAIN_HEIGHT;
}

// Not in the seed: the template's three levels of detail on this terrain. A smaller
// copy of the ground, folded over at its middle height, puts sharp crests on it. The
// weights shrink fast enough that one octave count serves both marching and normals.
float terrainM(vec2 p) {
    float fold = abs(terrainSignFlip(4.0 * p.yx + 700.0) - 0.36 * TERRAIN_HEIGHT);
    return terrainSignFlip(p) + 0.12 * TERRAIN_HEIGHT - 0.45 * fold;
}
float terrainH(vec2 p) { return terrainM(p); }
// The camera flies over an average of its surroundings, which is smooth.
float terrainL(vec2 p) {
    return 0.25 * (terrainSignFlip(p + vec2(40.0, 0.0)) + terrainSignFlip(p - vec2(40.0, 0.0))
        + terrainSignFlip(p + vec2(0.0, 40.0)) + terrainSignFlip(p - vec2(0.0, 40.0)));
}
