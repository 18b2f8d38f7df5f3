// a division by a zero that the compiler knows gives infinity, also where smoothstep's edges are equal
// expect: 63 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    float z = float(min(iFrame, 0));
    int okR = 0;
    if ((z + 1.) / 0. > 1e30) okR += 1;
    if ((z - 1.) / 0. < -1e30) okR += 2;
    if (all(greaterThan((vec3(1, 2, 3) + z) / 0., vec3(1e30)))) okR += 4;
    if (all(lessThan((vec2(-1, -2) + z) / vec2(0), vec2(-1e30)))) okR += 8;
    if (smoothstep(.5, .5, z + .6) == 1.) okR += 16;
    if (smoothstep(.5, .5, z + .4) == 0.) okR += 32;
    fragColor = vec4(vec3(okR, 0, 0) / 255.0, 1.0);
}
