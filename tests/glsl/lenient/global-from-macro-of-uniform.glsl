// an initialiser holds a macro that stands for a uniform
// expect: 1 0 0
#define T (iTime * 2.0)
float a = T;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a == 1.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
