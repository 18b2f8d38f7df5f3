bool castRay(vec3 ro, vec3 rd, out float resT) {
const float dt = 0.0001;
for (float t = 0.; t <= 1000.; t += dt) {
vec3 p = ro + rd * t;
float h = terrain(p.x, p.z);
if (p.y < h) {
resT = t - 0.5 * dt;
return true;
}
}
return false;
}
