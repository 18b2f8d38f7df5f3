// 256 ?: in a row
// expect: 3 0 0
#define A(n) x == n ? 2 * (n) :
#define B(n) A(n) A(n + 1) A(n + 2) A(n + 3)
#define C(n) B(n) B(n + 4) B(n + 8) B(n + 12)
#define D(n) C(n) C(n + 16) C(n + 32) C(n + 48)
int twice(int x) { return D(0) D(64) D(128) D(192) -1; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (twice(Z + 200) == 400) okR += 1;
    if (twice(Z + 256) == -1) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
