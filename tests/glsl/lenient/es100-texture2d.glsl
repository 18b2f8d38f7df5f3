// texture2D of ES 1.00
// expect: 3 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (texture2D(iChannel0, fragCoord / 8.0) == vec4(0.0, 0.0, 0.0, 1.0)) okR += 1;
    if (texture2D(iChannel0, vec2(0.5), 1.0).a == 1.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
