// ?: of structs is returned
// expect: 3 0 0
struct Hit { float d; int id; };
Hit nearer(Hit a, Hit b) { return a.d < b.d ? a : b; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    Hit a = Hit(1.0, 7), b = Hit(2.0, 8);
    if (nearer(a, b).id == 7) okR += 1;
    if (nearer(b, a) == a) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
