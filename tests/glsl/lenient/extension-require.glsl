// the same is required
// expect: 1 0 0
#extension GL_OES_standard_derivatives : require
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (dFdy(fragCoord.y) == 1.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
