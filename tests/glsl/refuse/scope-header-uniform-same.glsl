// May uniform iTime be redeclared with the same type?
uniform float iTime;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
