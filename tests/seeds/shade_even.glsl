void main() {
gl_FragColor = (0, 0, 0, 1);

vec3 PWorld = ...; // Point of pixel in world space
vec3 rd = normalize(PWorld); // The ray direction
vec3 ro = vec3(0.);

float t;
if (castRay(ro, rd, t)) {
vec3 p = ro + rd * t;
gl_FragColor = vec4(computeShadingForPoint(p), 1.);
} else {
gl_FragColor = vec4(0.8, 0.85, 9.); // Sky color
}
}
