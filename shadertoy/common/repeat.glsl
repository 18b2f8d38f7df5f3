vec3 repeat(vec3 p, float c) {
    return mod(p,c) - 0.5 * c;
}
