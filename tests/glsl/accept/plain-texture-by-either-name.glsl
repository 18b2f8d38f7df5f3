// a plain fragment shader's texture is the first channel, and texture2D its function; none is bound
// expect: 0 0 0
uniform sampler2D uTexture;
vec4 read(sampler2D uTexture, vec2 at) { return texture2D(uTexture, at); }
void main() { gl_FragColor = read(uTexture, vec2(0.5)) + vec4(textureSize(uTexture, 0) - 1, 0, 0); }
