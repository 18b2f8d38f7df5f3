float scene(vec3 p) {
float plane = p.y + 1.0;
float sphere = sdSphere(p - vec3(0.0, 1.0, 0.0), 1.0);

float distance = min(sphere, plane);
return distance;
}
