// May an out-of-range constant index stand in dead code (if (false))?
void mainImage(out vec4 c, in vec2 f) {
float a[2]; if (false) c.x = a[2];
c = vec4(0.0);
}
