// the members of a global struct are not constant
// expect: 3 0 0
struct S { float time; vec2 size; };
S s = S(iTime, iResolution.xy);
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (s.time == 0.5) okR += 1;
    if (s.size == vec2(8.0)) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
