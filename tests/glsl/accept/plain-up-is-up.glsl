// a plain fragment shader: both coordinates grow to the right and upward
// expect-at: 0 0 0 0 0
// expect-at: 7 0 255 0 0
// expect-at: 0 7 0 255 255
// expect-at: 7 7 255 255 255
varying vec2 vUv;
void main() { gl_FragColor = vec4(step(0.5, vUv), step(4.0, gl_FragCoord.y), 1.0); }
