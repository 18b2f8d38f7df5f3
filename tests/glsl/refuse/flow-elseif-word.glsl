// May elseif be written?
void mainImage(out vec4 c, in vec2 f) {
if (f.x > 0.) c.x = 1.; elseif (f.x < 0.) c.x = 2.;
c = vec4(0.0);
}
