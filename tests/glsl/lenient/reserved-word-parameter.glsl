// reserved words are names of parameters
// expect: 3 0 0
void split(in float input, out float output, int common) { output = input * float(common); }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    float x;
    split(2.0, x, 3);
    if (x == 6.0) okR += 1;
    x = 1.0;
    split(x, x, 4);
    if (x == 4.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
