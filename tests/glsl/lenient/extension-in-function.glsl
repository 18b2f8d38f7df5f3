// an extension is enabled within a function
// expect: 1 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    int okR = 0;
    int Z = min(iFrame, 0);
#extension GL_EXT_shader_texture_lod : enable
    okR += 1;
    fragColor = vec4(float(okR) / 255.0, 0.0, 0.0, 1.0);
}
