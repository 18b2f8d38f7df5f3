// initialisers run once, before mainImage: later changes of what they read do not matter
// expect: 7 0 0
float a = 3.0;
float b = a * 2.0;
void change() { a = 50.0; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    change();
    if (a == 50.0) okR += 1;
    if (b == 6.0) okR += 2;
    a = b;
    if (b == 6.0 && a == 6.0) okR += 4;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
