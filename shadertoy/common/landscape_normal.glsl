// Not in the seed, whose getNormal looks 0.01 to each side. Far away that is finer than a
// pixel, and makes speckles of what no one can see.
vec3 getNormalAt(vec3 p, float t) {
    vec2 e = vec2(0.002 + 0.002 * t, 0.0);
    return normalize(scene(p) - vec3(scene(p - e.xyy), scene(p - e.yxy), scene(p - e.yyx)));
}
