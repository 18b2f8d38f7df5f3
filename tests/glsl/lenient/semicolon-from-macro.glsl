// a semicolon after a macro that brings its own
// expect: 3 0 0
#define ONE float one() { return 1.0; }
#define TWO const float two = 2.0;
ONE;
TWO;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (one() == 1.0) okR += 1;
    if (two == 2.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
