// unset-variable in 8 pixels from (2, 0)
vec3 light;
void prepare(float x) {
    if (x != 2.0) light = vec3(1.0);
}
void mainImage(out vec4 c, in vec2 p) {
    prepare(floor(p.x));
    c = vec4(light, 1.0); // here
}
