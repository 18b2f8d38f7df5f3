// a constant array, of which one element is used, has more than 64 KiB
// expect: 1 0 0
#define P(x) x, x, x, x
#define Q(x) P(x), P(x), P(x), P(x)
#define R(x) Q(x), Q(x), Q(x), Q(x)
#define S(x) R(x), R(x), R(x), R(x)
const mat4 a[] = mat4[](S(mat4(2.0)), S(mat4(3.0)), S(mat4(4.0)), S(mat4(5.0)), mat4(6.0));
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    const float six = a[1024][3][3];
    if (six == 6.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
