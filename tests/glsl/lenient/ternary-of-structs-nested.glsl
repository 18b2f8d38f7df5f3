// ?: of structs within ?: of structs
// expect: 7 0 0
struct S { int n; };
S pick(int k) { return k == 0 ? S(10) : k == 1 ? S(20) : S(30); }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (pick(Z).n == 10) okR += 1;
    if (pick(Z + 1).n == 20) okR += 2;
    if (pick(Z + 2).n == 30) okR += 4;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
