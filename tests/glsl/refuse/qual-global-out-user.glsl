// May the user declare a second `out vec4` without a location?
out vec4 extra;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
