void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 col = texelFetch(iChannel0, ivec2(fragCoord), 0).rgb;
    col = 1.0 - exp(-col * 2.0);
    col = pow(col, vec3(1.0 / 2.2));
    fragColor = vec4(col, 1.0);
}
