// an initialiser assigns to another global variable
// expect: 3 0 0
float a;
float b = (a = 2.0) + 1.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a == 2.0) okR += 1;
    if (b == 3.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
