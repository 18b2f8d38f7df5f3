// May void be compared?
void mainImage(out vec4 c, in vec2 f) {
bool b = mainImage(c, f) == mainImage(c, f);
c = vec4(0.0);
}
