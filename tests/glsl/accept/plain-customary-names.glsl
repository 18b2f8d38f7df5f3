// a plain fragment shader: customary names have the host's values, in the types that it declares
// expect: 255 1 0
#ifdef GL_ES
precision mediump float;
#endif
uniform highp float u_time, own;
uniform vec2 u_resolution;
uniform vec3 resolution;
uniform vec4 uMouse;
uniform vec2 mouse, other;
varying vec2 vUv;
vec2 atStart = u_resolution * 2.0;
void main()
{
    int okR = 0, okG = 0;
    if (u_time == 0.5) okR += 1;
    if (u_resolution == vec2(8.0)) okR += 2;
    if (resolution == vec3(8.0, 8.0, 1.0)) okR += 4;
    if (uMouse == vec4(0.0)) okR += 8;
    if (mouse == vec2(0.0)) okR += 16;
    if (vUv == gl_FragCoord.xy / 8.0) okR += 32;
    if (atStart == vec2(16.0)) okR += 64;
    if (own == 0.0) okR += 128;
    if (other == vec2(0.0)) okG += 1;
    gl_FragColor = vec4(float(okR) / 255.0, float(okG) / 255.0, 0.0, 1.0);
}
