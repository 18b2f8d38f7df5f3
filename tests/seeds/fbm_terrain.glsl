float terrain(float x, float z) {
return fbm(vec2(x, z), 2);
}
