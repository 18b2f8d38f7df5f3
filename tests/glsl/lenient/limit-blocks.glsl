// blocks nest 256 deep
// expect: 1 0 0
#define B(x) {{{{x}}}}
#define C(x) B(B(B(B(x))))
#define D(x) C(C(C(C(x))))
#define E(x) D(D(D(D(x))))
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    E(okR += 1;)
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
