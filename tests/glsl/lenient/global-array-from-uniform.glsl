// the elements of a global array are not constant
// expect: 3 0 0
float a[3] = float[](1.0, iTime, iResolution.x);
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a[1 + Z] == 0.5) okR += 1;
    if (a == float[](1.0, 0.5, 8.0)) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
