// a plain fragment shader of GLSL ES 3.00, which names its colour itself
// expect: 51 102 255
layout(location = 0) out vec4 colour;
void main(void)
{
    colour = vec4(0.2, 0.4, 1.0, 1.0);
}
