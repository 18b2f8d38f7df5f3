bool castRay(vec3 ro, vec3 rd, out float resT) {
float dt = 0.0001;
float lastH = terrain(ro.x, ro.z);
float lastY = ro.y;

for (float t = 0.; t <= 1000.; t += dt) {
vec3 p = ro + rd * t;
float h = terrain(p.x, p.z);
if (p.y < h) {
// Interpolate between lastH and h
resT = t - dt + dt * (lastH - lastY) / (p.y - lastY - h + lastH);
return true;
}
lastH = h;
lastY = p.y;
// Make dt proportional to t
dt = 0.01 * t;
}

return false;
}
