// a global variable begins with a texel
// expect: 1 0 0
vec4 texel = texelFetch(iChannel0, ivec2(0), 0);
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (texel == vec4(0.0, 0.0, 0.0, 1.0)) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
