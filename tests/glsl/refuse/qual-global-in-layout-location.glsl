// May a fragment input have layout(location = 0)?
layout(location = 0) in vec2 myIn;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
