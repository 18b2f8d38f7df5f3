// between edges that turn out to be equal it is a step, and not whatever a driver makes of a division by a zero it sees
// expect-at: 1 3 0 255 0
// expect-at: 6 3 255 0 0
float edge(float radius, float x)
{
    return smoothstep(radius - radius * 0.0, radius + radius * 0.0, x);
}
void mainImage(out vec4 o, in vec2 p)
{
    float x = p.x / 8.0;
    o = vec4(edge(0.5, x), 1.0 - edge(0.5, x), 0.0, 1.0);
}
