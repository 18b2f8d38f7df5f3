// May the user declare `in int` without flat?
in int myIn;
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
