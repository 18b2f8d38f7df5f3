// initialisers run from top to bottom, each once
// expect: 15 0 0
int calls = 0;
int next() { return ++calls; }
int a = next();
int b = next() * 10, c = next() * 100;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (a == 1) okR += 1;
    if (b == 20) okR += 2;
    if (c == 300) okR += 4;
    if (calls == 3) okR += 8;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
