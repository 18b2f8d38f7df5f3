function distSphere(vec3 pos, float r) {
return mag(pos) - r;
}
