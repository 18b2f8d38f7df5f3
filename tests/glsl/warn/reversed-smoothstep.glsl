// smoothstep whose edges stand in falling order
void mainImage(out vec4 c, in vec2 p) { c = vec4(smoothstep(1., .2, p.x)); }
