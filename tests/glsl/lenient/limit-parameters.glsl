// a function has 257 parameters
// expect: 3 0 0
#define P(x) x, x, x, x
#define Q(x) P(x), P(x), P(x), P(x)
#define R(x) Q(x), Q(x), Q(x), Q(x)
#define S(x) R(x), R(x), R(x), R(x)
int last(S(int), int n) { return n; }
int first(int n, S(int)) { return n; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (last(S(1), Z + 5) == 5) okR += 1;
    if (first(Z + 6, S(1)) == 6) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
