// May a sampler uniform have layout(binding = 1)?
layout(binding = 1) uniform sampler2D x;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
