// Not in the seed, which calls it: a point turned about an axis.
vec3 rotate(vec3 p, vec3 axis, float angle) {
    vec3 along = axis * dot(axis, p);
    return along + cos(angle) * (p - along) + sin(angle) * cross(axis, p);
}

// The seed's three ways of placing a ball. Its turn shows nothing, as a ball looks the same
// from all sides and two times 3.14 is a whole turn.
#define scene moved
float scene(vec3 p) {
    float plane = p.y + 1.0;
    float sphere = sdSphere(p - vec3(0.0, 1.0, 0.0), 1.0);

    float distance = min(sphere, plane);
    return distance;
}
#undef scene
#define scene turned
float scene(vec3 p) {
    vec3 p1 = rotate(p, vec3(0.0, 1.0, 0.0), 3.14 * 2.0);
    float distance = sdSphere(p1, 1.0);

    return distance;
}
#undef scene
#define scene scaled
float scene(vec3 p) {
    float scale = 2.0;
    vec3 p1 = p * scale;

    float sphere = sdSphere(p1, 1.5);
    float distance = sphere / scale;

    return distance;
}
#undef scene

// Not in the seed: all three beside each other, and a box, on which turning shows.
float scene(vec3 p) {
    float d = moved(p);
    d = min(d, turned(p - vec3(-2.5, 0.0, -0.3)));
    d = min(d, scaled(p - vec3(2.3, -0.25 + 0.3 * sin(uTime), 0.5)));
    vec3 q = rotate(p - vec3(0.6, -0.4, 2.0), normalize(vec3(0.3, 1.0, 0.2)), 0.8 * uTime);
    return min(d, sdBox(q, vec3(0.4)) - 0.05);
}
#undef EYE
#define EYE vec3(0.3, 1.5, 5.6)
#undef PAINT
#define PAINT (p.y < -0.97 ? vec3(0.26 + 0.3 * mod(floor(p.x) + floor(p.z), 2.0)) : 0.5 + 0.35 * cos(vec3(0.3, 1.6, 3.0) + 1.1 * p.x))
