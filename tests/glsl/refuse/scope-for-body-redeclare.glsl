// May a for body block redeclare the loop variable?
void mainImage(out vec4 c, in vec2 f) {
for (int i = 0; i < 3; i++) { float i = 1.0; c.x += i; }
c = vec4(0.0);
}
