// texture2DLodEXT of ES 1.00
// expect: 1 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (texture2DLodEXT(iChannel0, vec2(0.5), 0.0) == vec4(0.0, 0.0, 0.0, 1.0)) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
