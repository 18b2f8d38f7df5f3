void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    if (fragCoord.x) fragColor = vec4(1.0);
}
