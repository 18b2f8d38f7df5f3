// an element of the array that ?: chose
// expect: 3 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    int a[3] = int[](1, 2, 3), b[3] = int[](4, 5, 6);
    if ((Z == 0 ? a : b)[Z + 1] == 2) okR += 1;
    if ((Z != 0 ? a : b)[2] == 6) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
