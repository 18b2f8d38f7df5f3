// May a bool have a precision qualifier?
void mainImage(out vec4 c, in vec2 f) {
highp bool b = true;
c = vec4(0.0);
}
