// May functions be overloaded by in/out alone (both defined)?
void g(in float x) { }
void g(out float x) { x = 1.; }
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
