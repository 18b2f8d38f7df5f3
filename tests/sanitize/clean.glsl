// nothing
// All of this asks before it does what it cannot.
vec3 light = vec3(0.6, 0.8, 0.0);
float gain;
const float SCALE = 1.0 / 3.0;

float share(float x, float n) {
    return n != 0.0 ? x / n : 0.0;
}

vec3 direction(vec3 v) {
    float l = dot(v, v);
    if (l == 0.0) return vec3(0.0, 1.0, 0.0);
    return normalize(v);
}

void split(in float x, out float whole, inout float rest) {
    whole = floor(x);
    rest += x - whole;
}

void mainImage(out vec4 c, in vec2 p) {
    vec2 q = floor(p) - 3.0;
    gain = 2.0;
    float whole, rest = 0.0;
    split(p.x * SCALE, whole, rest);
    vec3 v;
    v.x = q.x;
    v.yz = vec2(q.y, whole);
    float weights[3];
    for (int i = 0; i < 3; i++) weights[i] = float(i) + gain;
    int near = clamp(int(p.x), 0, 2);
    float chosen;
    switch (near) {
        case 0: chosen = weights[0]; break;
        default: chosen = weights[near];
    }
    bool steep = q.x != 0.0 && 1.0 / q.x > 0.5 || q.y != 0.0 && sqrt(abs(q.y)) > 1.0;
    float shade = steep ? acos(clamp(q.x, -1.0, 1.0)) : pow(abs(q.x) + 0.1, 2.2);
    uint bits = uint(p.x) << (uint(p.y) & 31u);
    shade += share(1.0, q.y) + dot(direction(v), light) + smoothstep(0.0, 8.0, p.x);
    vec4 far = vec4(1e20) * 1e10;
    c = vec4(shade, rest + mod(q.x, 3.0), chosen + float(bits % 7u), min(far.x, 1.0));
}
