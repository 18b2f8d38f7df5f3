// May mainImage take `inout vec4`?
void mainImage(inout vec4 c, in vec2 f) { c = vec4(0.); }
