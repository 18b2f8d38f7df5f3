// May `__samplerExternal2DY2YEXT` (not reserved in ES 3.00) be a local variable name?
void mainImage(out vec4 c, in vec2 f) {
float __samplerExternal2DY2YEXT = 1.0;
c.x = __samplerExternal2DY2YEXT;
c = vec4(0.0);
}
