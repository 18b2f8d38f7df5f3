// a plain fragment shader that leaves the declarations to its host
// expect: 7 0 0
float twice(float time) { return 2.0 * time; }
void main()
{
    int okR = 0;
    if (twice(uTime) == 1.0) okR += 1;
    if (uResolution == vec2(8.0)) okR += 2;
    if (vUv * uResolution == gl_FragCoord.xy) okR += 4;
    gl_FragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
