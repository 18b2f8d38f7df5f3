// May while(true)'s only break belong to an inner loop?
void mainImage(out vec4 c, in vec2 f) {
while (true) { for (int i = 0; i < 3; i++) { break; } }
c = vec4(0.0);
}
