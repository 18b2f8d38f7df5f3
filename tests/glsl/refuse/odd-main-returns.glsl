// May mainImage return vec4?
vec4 mainImage(out vec4 c, in vec2 f) { return vec4(0.); }
