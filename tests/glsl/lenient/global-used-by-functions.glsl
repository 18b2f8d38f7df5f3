// a global variable with such an initialiser is seen and changed by functions
// expect: 7 0 0
float level = iTime * 4.0;
float look() { return level; }
void rise() { level += 1.0; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (look() == 2.0) okR += 1;
    rise();
    if (look() == 3.0) okR += 2;
    if (level == 3.0) okR += 4;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
