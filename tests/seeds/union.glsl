float scene(vec3 p) {
float plane = p.y;
float sphere = sdSphere(p, 1.0);

float distance = min(sphere, plane);
return distance;
}
