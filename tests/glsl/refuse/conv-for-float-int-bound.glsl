// May `i < 3` compare a float loop variable with an int?
void mainImage(out vec4 c, in vec2 f) {
for (float i = 0.; i < 3; i++) { c.x += i; }
c = vec4(0.0);
}
