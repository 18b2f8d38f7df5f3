// an expression nests 256 additions deep
// expect: 1 0 0
#define A(x) (x + one)
#define B(x) A(A(A(A(x))))
#define C(x) B(B(B(B(x))))
#define D(x) C(C(C(C(x))))
#define E(x) D(D(D(D(x))))
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    float one = 1.0 + float(Z);
    float x = E(one);
    if (x == 257.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
