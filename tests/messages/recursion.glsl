float depth(int n) { return n == 0 ? 0.0 : 1.0 + depth(n - 1); }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(depth(3));
}
