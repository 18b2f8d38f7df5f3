float first() { return one; }

float second() { return two; }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(first(), second(), 0.0, 1.0);
}
