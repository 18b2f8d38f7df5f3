// May mat3(mat2, 1.) be constructed?
void mainImage(out vec4 c, in vec2 f) {
mat3 m = mat3(mat2(1.), 1., 1., 1., 1., 1.);
c = vec4(0.0);
}
