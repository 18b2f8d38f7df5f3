// ?: chooses between structs that are constant, by a constant
// expect: 1 0 0
struct S { float a; ivec2 b; };
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    const S s = true ? S(1.0, ivec2(2, 3)) : S(4.0, ivec2(5, 6));
    if (s.b == ivec2(2, 3)) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
