// May `sample` (reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float sample = 1.0;
c.x = sample;
c = vec4(0.0);
}
