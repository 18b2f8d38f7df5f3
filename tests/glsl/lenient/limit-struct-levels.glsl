// structs nest five deep
// expect: 3 0 0
struct A { float x; };
struct B { A a; };
struct C { B b; };
struct D { C c; };
struct E { D d; };
struct F { E e; };
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    F f = F(E(D(C(B(A(2.0))))));
    if (f.e.d.c.b.a.x == 2.0) okR += 1;
    f.e.d.c.b.a.x += 1.0;
    if (f.e == E(D(C(B(A(3.0)))))) okR += 2;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
