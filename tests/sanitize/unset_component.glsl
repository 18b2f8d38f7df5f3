// unset-variable in 64 pixels from (0, 0)
void mainImage(out vec4 c, in vec2 p) {
    vec3 v;
    v.x = 1.0;
    v.zy = p;
    c.xyz = v;
    c.x = v.x;
    c = c; // here
}
