// an initialiser chooses by a uniform
// expect: 1 0 0
float a = iTime > 0.25 ? 2.0 : 3.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a == 2.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
