vec3 getNormal(vec3 p) {
vec2 e = vec2(.01, 0);

vec3 n = scene(p) - vec3(
scene(p-e.xyy),
scene(p-e.yxy),
scene(p-e.yyx));

return normalize(n);
}
