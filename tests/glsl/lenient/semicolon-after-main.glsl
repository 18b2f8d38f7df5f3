// a semicolon after mainImage
// expect: 1 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord) { fragColor = vec4(1.0 / 255.0, 0.0, 0.0, 1.0); };
