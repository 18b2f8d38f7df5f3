// two semicolons after a struct
// expect: 1 0 0
struct S { float a; };;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    S s = S(1.0);
    if (s.a == 1.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
