float scene(vec3 p) {
vec3 p1 = rotate(p, vec3(0.0, 1.0, 0.0), 3.14 * 2.0);
float distance = sdSphere(p1, 1.0);

return distance;
}
