// May an array size be a non-const int global?
int N = 4;
float a[N];
void mainImage(out vec4 c, in vec2 f) {

c = vec4(0.0);
}
