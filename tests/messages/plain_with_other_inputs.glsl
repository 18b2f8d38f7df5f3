varying vec2 vUv;
varying vec3 vNormal;

void main() {
    gl_FragColor = vec4(vUv, vNormal.x, 1.0);
    gl_FragColour.a = 0.5;
}
