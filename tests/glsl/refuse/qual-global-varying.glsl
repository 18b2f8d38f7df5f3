// May the user declare a varying?
varying vec2 v;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
