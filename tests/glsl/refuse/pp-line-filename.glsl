// May #line N "file" be written?
#line 100 "file.glsl"
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
