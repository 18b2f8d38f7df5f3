// May 0. < x < 1. be written?
void mainImage(out vec4 c, in vec2 f) {
bool b = 0. < f.x < 1.;
c = vec4(0.0);
}
