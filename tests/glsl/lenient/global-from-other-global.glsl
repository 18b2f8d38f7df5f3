// a global variable begins with the value of one above it
// expect: 3 0 0
float a = 3.0;
float b = a * 2.0, c = b + 1.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (b == 6.0) okR += 1;
    if (c == 7.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
