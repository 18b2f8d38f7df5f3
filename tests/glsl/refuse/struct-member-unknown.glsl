// May an unknown member be read?
struct S { float x; };
void mainImage(out vec4 c, in vec2 f) {
S s; c.x = s.y;
c = vec4(0.0);
}
