// ?: of structs is an argument
// expect: 3 0 0
struct S { float a; ivec2 b; };
float sum(S s) { return s.a + float(s.b.x); }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    S s = S(1.0, ivec2(2, 3)), t = S(4.0, ivec2(5, 6));
    if (sum(Z == 0 ? s : t) == 3.0) okR += 1;
    if (sum(Z != 0 ? s : t) == 9.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
