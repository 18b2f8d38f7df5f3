// May a sampler array be indexed by a uniform (dynamic)?
uniform sampler2D tex[4];
void mainImage(out vec4 c, in vec2 f) {
c = texture(tex[iFrame], f);
c = vec4(0.0);
}
