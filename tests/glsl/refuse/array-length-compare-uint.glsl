// Is .length() an int (assigned to uint refused)?
void mainImage(out vec4 c, in vec2 f) {
float a[3]; uint n = a.length();
c = vec4(0.0);
}
