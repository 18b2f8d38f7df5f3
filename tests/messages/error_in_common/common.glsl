vec3 tint(float t) {
    return 0.5 + 0.5 * cos(t + vec3(0, 2, 4)) * strength;
}
