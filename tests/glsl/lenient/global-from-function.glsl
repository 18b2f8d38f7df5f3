// a global variable begins with the result of a function
// expect: 3 0 0
float twice(float x) { return 2.0 * x; }
float a = twice(4.0);
vec2 b = vec2(twice(1.0), a);
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a == 8.0) okR += 1;
    if (b == vec2(2.0, 8.0)) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
