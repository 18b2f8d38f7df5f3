// May a ternary have vec2 and vec3 branches?
void mainImage(out vec4 c, in vec2 f) {
vec2 v = f.x > 0. ? f : vec3(1.);
c = vec4(0.0);
}
