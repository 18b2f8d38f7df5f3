// ---- Canyon ----
// Not in the seed: the heightfield that its mapCanyon displaces.
float canyonCentre(float z) {
    return 14.0 * sin(0.031 * z) + 7.0 * sin(0.073 * z + 1.0);
}

// The walls rise from the river bed in three terraces to a plateau of low hills. Noise
// moves the walls to and fro, which makes bays and buttresses, but leaves the flight its
// way. It is computed noise: on so large a scale the steps of a texture's filter would
// show as flutes in the walls.
float terrainM(vec2 p) {
    float n = 0.6 * noise(p * 0.035) + 0.28 * noise(p * 0.09) + 0.12 * noise(p * 0.21);
    float across = abs(p.x - canyonCentre(p.y));
    across += 36.0 * (n - 0.5) * smoothstep(3.0, 16.0, across);
    float rise = 3.0 * clamp((across - 8.0) / 30.0, 0.0, 1.0);
    float level = min(floor(rise), 2.0);
    float terrace = (level + smoothstep(0.1, 0.85, rise - level)) / 3.0;
    return 2.0 * n + 30.0 * terrace + 0.08 * min(across, 60.0);
}
float terrainL(vec2 p) { return 0.0; }

float noise3D(in vec3 x) {
    vec3 p = floor(x); vec3 f = fract(x);
    f = f * f * (3.0 - 2.0 * f);
    vec2 uv = (p.xy + vec2(37.0, 17.0) * p.z) + f.xy;
    vec2 rg = textureLod(iChannel0, (uv + 0.5) / 256.0, 0.0).yx;
    return mix(rg.x, rg.y, f.z);
}
const mat3 m3 = mat3(0.00, 0.80, 0.60, -0.80, 0.36,-0.48, -0.60,-0.48, 0.64);
float displacement(vec3 p) {
    float f = 0.5 * noise3D(p); p = m3 * p * 2.02;
    f += 0.25 * noise3D(p); p = m3 * p * 2.03;
    f += 0.125 * noise3D(p); p = m3 * p * 2.01;
    f += 0.0625 * noise3D(p);
    return f;
}
float mapCanyon(vec3 p) {
    float h = terrainM(p.xz);
    float dis = displacement(0.25 * p * vec3(1.0, 4.0, 1.0)) * 3.0;
    return (dis + p.y - h) * 0.25;
}

