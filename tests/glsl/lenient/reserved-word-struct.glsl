// a reserved word is the name of a struct
// expect: 3 0 0
struct resource { float a; };
resource made() { return resource(2.0); }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    resource r = made(), s = resource(3.0);
    if (r.a == 2.0) okR += 1;
    if (s.a == 3.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
