// May mainImage take `out vec3`?
void mainImage(out vec3 c, in vec2 f) { c = vec3(0.); }
