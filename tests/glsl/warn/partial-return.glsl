// functions of which a path may end without a result, and others that only look so
float branch(float x) { if (x > 1.) return 1.; }
float loop(float x) { for (int i = 0; i < 4; i++) if (x > float(i)) return x; }
float choice(int i) { switch (i) { case 0: return 1.; case 1: break; default: return 2.; } }
float both(float x) { if (x > 1.) return 1.; else return 2.; }
float endless(float x) { for (;;) { x *= 2.; if (x > 9.) return x; } }
float every(int i) { switch (i) { case 0: case 1: return 1.; default: return 2.; } }
float once(float x) { do { if (x > 1.) return 1.; return 2.; } while (x > 0.); }
float dead(float x) { if (true) return x; }
float never(float x) { if (x > 1.) discard; else return x; }
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(branch(p.x), loop(p.x), choice(int(p.x)), both(p.x));
    c += vec4(endless(p.x), every(int(p.y)), once(p.x), dead(p.x) + never(p.x));
}
