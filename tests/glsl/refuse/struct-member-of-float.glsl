// May a member be read from a float?
void mainImage(out vec4 c, in vec2 f) {
float q; c.x = q.foo;
c = vec4(0.0);
}
