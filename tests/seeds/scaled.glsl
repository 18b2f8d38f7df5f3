float scene(vec3 p) {
float scale = 2.0;
vec3 p1 = p * scale;

float sphere = sdSphere(p1, 1.5);
float distance = sphere / scale;

return distance;
}
