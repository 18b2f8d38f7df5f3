const float SPEED = 2.0;

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    SPEED = 3.0;
    iTime = 0.0;
    fragColor = vec4(SPEED);
}
