// an array that is the parameter of a function that nobody calls has more than 64 KiB
// expect: 1 0 0
vec4 unused(const vec4 a[4100], int i) { return a[i]; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
