// a local array of a function that nobody calls has more than 64 KiB
// expect: 1 0 0
float unused(int i)
{
    float a[16400];
    a[i] = 2.0;
    return a[0];
}
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
