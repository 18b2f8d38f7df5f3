// ---- Camera ----
// Not in the seed: the flight follows the river bed.
vec3 cameraPath(float t) {
    float z = -18.0 * t;
    return vec3(canyonCentre(z), 0.0, z);
}
