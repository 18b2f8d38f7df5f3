// May mul be called?
void mainImage(out vec4 c, in vec2 f) {
vec2 x = mul(mat2(1.), f);
c = vec4(0.0);
}
