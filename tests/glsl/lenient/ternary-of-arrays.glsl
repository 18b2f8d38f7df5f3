// ?: chooses between arrays
// expect: 3 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    float a[2] = float[](1.0, 2.0), b[2] = float[](3.0, 4.0);
    float c[2] = Z == 0 ? a : b;
    if (c == a) okR += 1;
    c = Z != 0 ? a : b;
    if (c == b) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
