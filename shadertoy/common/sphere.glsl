// ---- A ball as a distance field ----
float sdSphere(vec3 p, float radius){
    return length(p) - radius;
}
