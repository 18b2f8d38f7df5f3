// ---- SDF Objects ----
// Not in the seed: it names the parts of this composition only.
#define GRID_SIZE 40.0
#define STONE_HEIGHT 12.0
#define STONE_REACH 900.0

// How far a ray may go within its cell: what stands in the next is not known here.
float toNextCell(vec3 p, vec3 rd) {
    vec2 at = p.xz - GRID_SIZE * floor(p.xz / GRID_SIZE);
    vec2 way = mix(at, GRID_SIZE - at, step(0.0, rd.xz)) / max(abs(rd.xz), 1e-4);
    return min(way.x, way.y) + 0.02;
}

// How far a point is from the stone in its cell, if there is one.
float stone(vec3 p) {
    float gridSize = GRID_SIZE;
    vec2 cell = floor(p.xz/gridSize);
    float chance = hash(cell);
    if (chance < 0.35) return 1e3;
    vec2 place = 0.22 * gridSize * (2.0 * vec2(hash(cell + 71.3), hash(cell + 13.7)) - 1.0);
    vec2 foot = gridSize * (cell + 0.5) + place;
    vec3 q = vec3(p.x - foot.x, p.y - terrainFBM(foot, 6), p.z - foot.y);
    float turn = 6.283 * hash(cell + 5.1);
    q.xz = mat2(cos(turn), -sin(turn), sin(turn), cos(turn)) * q.xz;
    q.x += 0.12 * q.y * (chance - 0.7);
    float tall = STONE_HEIGHT * (0.5 + chance);
    vec3 size = vec3(2.4 - 0.09 * q.y, tall, 1.3 - 0.05 * q.y);
    vec3 away = abs(q) - max(size, 0.2);
    float box = length(max(away, 0.0)) + min(max(away.x, max(away.y, away.z)), 0.0) - 0.35;
    return 0.8 * box;
}

// Stones are looked for only where a ray may meet one: not far above the ground, and not far
// from the eye, where they are smaller than a pixel.
bool mayMeetStone(float ground, float t) {
    return ground < 6.0 * STONE_HEIGHT && t < STONE_REACH;
}

float raymarch(in vec3 ro, in vec3 rd) {
    float t = 0.5;
    for (int i = 0; i < MAX_STEPS; i++) {
        vec3 pos = ro + t * rd;
        float ground = pos.y - terrainM(pos.xz);
        float h = STEP_FACTOR * ground;
        float most = MAX_DIST;
        if (mayMeetStone(ground, t)) {
            h = min(h, stone(pos));
            most = toNextCell(pos, rd);
        }
        if (abs(h) < 0.0008 * t) return t;
        if (t > MAX_DIST || (rd.y > 0.0 && pos.y > TERRAIN_HEIGHT)) return -1.0;
        t += min(h, most);
    }
    return -1.0;
}

vec3 stoneNormal(vec3 p) {
    vec2 e = vec2(0.02, -0.02);
    return normalize(e.xyy * stone(p + e.xyy) + e.yyx * stone(p + e.yyx)
        + e.yxy * stone(p + e.yxy) + e.xxx * stone(p + e.xxx));
}

// Whether the sun is behind a stone near by: 0 where it is.
float stoneShadow(vec3 p, vec3 sunDir) {
    float res = 1.0, t = 0.3;
    for (int i = 0; i < 40 && t < 70.0; i++) {
        float h = stone(p + t * sunDir);
        if (h < 0.01) return 0.0;
        res = min(res, SHADOW_K * h / t);
        t += min(max(h, 0.15), toNextCell(p + t * sunDir, sunDir));
    }
    return clamp(res, 0.0, 1.0);
}
