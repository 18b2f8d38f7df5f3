// an extension is enabled behind the first declaration
// expect: 1 0 0
float one() { return 1.0; }
#extension GL_EXT_shader_texture_lod : enable
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
    if (one() == 1.0) okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
