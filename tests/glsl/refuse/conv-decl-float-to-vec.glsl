// May a vec3 be initialised from a scalar?
void mainImage(out vec4 c, in vec2 f) {
vec3 v = 1.0;
c = vec4(0.0);
}
