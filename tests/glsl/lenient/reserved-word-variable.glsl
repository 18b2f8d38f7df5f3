// words that only desktop GLSL uses are names of variables
// expect: 15 0 0
float input = 1.0;
float output = 2.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    float sample = 4.0, filter = 8.0;
    if (input == 1.0) okR += 1;
    if (output == 2.0) okR += 2;
    if (sample == 4.0) okR += 4;
    if (filter == 8.0) okR += 8;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
