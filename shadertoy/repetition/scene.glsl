// Not in the seed, which describes it: a ball in every tile, and an eye that flies along the
// corners between them.
#define TILE 3.0
#define RADIUS 0.8
float scene(vec3 p) {
    return sdSphere(repeat(p, TILE), RADIUS);
}
#undef EYE
#define EYE vec3(0.0, 0.0, 5.0 - uTime)
#undef AIM
#define AIM vec3(0.6 * sin(0.2 * uTime), 0.3, -uTime)
#undef PAINT
#define PAINT (0.5 + 0.4 * cos(vec3(0.0, 2.0, 4.0) + floor(p.x / TILE) + 2.0 * floor(p.y / TILE) + 0.7 * floor(p.z / TILE)))
