// May `precision highp uint;` be stated?
precision highp uint;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
