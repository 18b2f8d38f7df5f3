// a discarded pixel makes no more rounds, which a neighbour's derivative sees (columns are pairs)
// expect-at: 0 0 140 0 0
// expect-at: 6 5 140 0 0
void mainImage(out vec4 o, in vec2 p)
{
    if (mod(p.x, 2.0) > 1.0) discard;
    float sum = 0.0;
    // The neighbour stays at 1, where its first round ended: 0 + 0 - 1 - 2 - 3.
    for (float x = 0.0; x < 5.0; x++) sum += dFdx(x);
    o = vec4((200.0 + 10.0 * sum) / 255.0, 0.0, 0.0, 1.0);
}
