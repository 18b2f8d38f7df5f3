// names of types that ES 3.00 lacks are names of variables
// expect: 15 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    float half = 0.5;
    int fixed = 1, long = 2;
    vec2 unsigned = vec2(3.0);
    if (half == 0.5) okR += 1;
    if (fixed == 1) okR += 2;
    if (long == 2) okR += 4;
    if (unsigned.y == 3.0) okR += 8;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
