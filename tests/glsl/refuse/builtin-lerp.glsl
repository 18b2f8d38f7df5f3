// May lerp be called?
void mainImage(out vec4 c, in vec2 f) {
float x = lerp(0., 1., .5);
c = vec4(0.0);
}
