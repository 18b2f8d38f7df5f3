// May cross(vec2, vec2) be called?
void mainImage(out vec4 c, in vec2 f) {
float x = cross(f, f);
c = vec4(0.0);
}
