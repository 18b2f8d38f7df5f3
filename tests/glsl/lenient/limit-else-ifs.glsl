// a ladder of else has 128 arms
// expect: 3 0 0
#define A(n) else if (x == n) r = 2 * (n);
#define B(n) A(n) A(n + 1) A(n + 2) A(n + 3)
#define C(n) B(n) B(n + 4) B(n + 8) B(n + 12)
int twice(int x)
{
    int r = -1;
    if (x < 0) r = 0;
    C(0) C(16) C(32) C(48) C(64) C(80) C(96) C(112)
    return r;
}
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (twice(Z + 127) == 254) okR += 1;
    if (twice(Z + 128) == -1) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
