// May `gl_` (not reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float gl_ = 1.0;
c.x = gl_;
c = vec4(0.0);
}
