float scene(vec3 p) {
    float distance = sdSphere(p, 1.0);
    return distance;
}
