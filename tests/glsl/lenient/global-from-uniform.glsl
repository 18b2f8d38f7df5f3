// a global variable begins with a uniform
// expect: 3 0 0
float t = iTime;
vec2 r = 1.0 / iResolution.xy;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (t == 0.5) okR += 1;
    if (r == vec2(0.125)) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
