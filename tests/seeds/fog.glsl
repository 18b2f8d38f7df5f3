// This fog is presented in Inigo Quilez's article
// It's a version of the fog function that keeps the "fog" at the
// bottom of the scene, and doesn't let it go above the horizon/mountains
vec3 fog(vec3 ro, vec3 rd, vec3 col, float d){
vec3 pos = ro + rd * d;
float sunAmount = max(dot(rd, lightPosition), 0.0);

float b = 1.3;
// Applying exponential decay to fog based on distance
float fogAmount = 0.2 * exp(-ro.y * b) * (1.0 - exp(-d * rd.y * b)) / rd.y;
vec3 fogColor = mix(vec3(0.5,0.2,0.15), vec3(1.1,0.6,0.45), pow(sunAmount,2.0));

return mix(col, fogColor, clamp(fogAmount,0.0,1.0));
}
