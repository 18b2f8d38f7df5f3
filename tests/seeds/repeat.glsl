vec3 repeat(vec3 p, float c) {
return mod(p,c) - 0.5 * c; // (0.5 *c centers the tiling around the origin)
}
