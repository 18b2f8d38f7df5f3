// integers divided by zero: all bits, but 0 for a signed quotient, as Mesa's drivers have it; vectors by component
// expect: 0 255 0
void mainImage(out vec4 o, in vec2 p) {
    int zero = int(p.x) - int(p.x);
    uint none = uint(zero);
    int seven = 7 + zero;
    bool holds = seven / zero == 0 && seven % zero == -1 && -seven % zero == -1;
    holds = holds && uint(seven) / none == 0xffffffffu && uint(seven) % none == 0xffffffffu;
    holds = holds && ivec2(seven) % ivec2(zero, 4) == ivec2(-1, 3);
    holds = holds && uvec3(seven) / uvec3(2u, none, 7u) == uvec3(3u, 0xffffffffu, 1u);
    o = holds ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
