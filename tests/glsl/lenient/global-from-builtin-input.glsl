// a global variable begins with gl_FragCoord
// expect-at: 0 0 5 5 0
// expect-at: 3 0 35 5 0
// expect-at: 7 6 75 65 0
vec2 p = gl_FragCoord.xy * 10.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord) { fragColor = vec4(p / 255.0, 0.0, 1.0); }
