// a variable that nothing sets
void mainImage(out vec4 c, in vec2 p) { float f; vec2 set; set.x = 1.; c = vec4(f + set.x); }
