// May structs nest 5 deep?
struct S0 { float x; };
struct S1 { S0 s; };
struct S2 { S1 s; };
struct S3 { S2 s; };
struct S4 { S3 s; };
void mainImage(out vec4 c, in vec2 f) {
S4 s;
c = vec4(0.0);
}
