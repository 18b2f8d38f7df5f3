// a reserved word is the name of a function
// expect: 3 0 0
float sample(vec2 p) { return p.x + p.y; }
float sample(float x) { return x; }
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (sample(vec2(1.0, 2.0)) == 3.0) okR += 1;
    if (sample(5.0) == 5.0) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
