// reserved words are members of a struct
// expect: 3 0 0
struct S { float half; vec2 partition; };
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    S s = S(1.0, vec2(2.0, 3.0));
    s.half += 1.0;
    if (s.half == 2.0) okR += 1;
    if (s.partition.yx == vec2(3.0, 2.0)) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
