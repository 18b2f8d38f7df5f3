// May a while on a bool variable never changed be written?
void mainImage(out vec4 c, in vec2 f) {
bool t = true; while (t) { c.x += 1.; }
c = vec4(0.0);
}
