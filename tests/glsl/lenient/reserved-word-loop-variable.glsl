// a reserved word counts a loop
// expect: 1 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    int sum = 0;
    for (int active = 0; active < 4; active++) sum += active;
    if (sum == 6) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
