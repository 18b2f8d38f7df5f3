// May mainImage's coordinate be `const in vec2`?
void mainImage(out vec4 c, const in vec2 f) { c = vec4(0.); }
