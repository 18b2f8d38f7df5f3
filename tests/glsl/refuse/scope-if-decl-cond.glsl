// May an if condition declare a variable?
void mainImage(out vec4 c, in vec2 f) {
if (bool b = f.x > 0.) c.x = 1.;
c = vec4(0.0);
}
