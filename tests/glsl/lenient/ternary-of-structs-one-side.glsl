// ?: of structs evaluates one side only
// expect: 7 0 0
struct S { float a; ivec2 b; };
int calls = 0;
S made(float a) { calls++; return S(a, ivec2(calls)); }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    S s = Z == 0 ? made(1.0) : made(2.0);
    if (s.a == 1.0) okR += 1;
    if (calls == 1) okR += 2;
    s = Z != 0 ? made(3.0) : made(4.0);
    if (s == S(4.0, ivec2(2))) okR += 4;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
