// May an output be a mat2?
layout(location = 1) out mat2 extra;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
