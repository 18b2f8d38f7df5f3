// Noise texture passed as a uniform
uniform sampler2D uTexture;

vec3 noised(vec2 x) {
vec2 p = floor(x);
vec2 f = fract(x);
vec2 u = f * f* (3.0 - 2.0 * f);

float a = textureLod(uTexture, (p+vec2(.0,.0)) /256.,0.).x;
float b = textureLod(uTexture, (p+vec2(1.0,.0)) /256.,0.).x;
float c = textureLod(uTexture, (p+vec2(.0,1.0)) /256.,0.).x;
float d = textureLod(uTexture, (p+vec2(1.0,1.0)) /256.,0.).x;

float noiseValue = a + (b - a) * u.x + (c - a) *
u.y + (a - b - c + d) * u.x * u.y;
vec2 noiseDerivative = 6.0 * f * (1.0 - f) * (vec2(b - a, c - a) +
(a - b - c + d) * u.yx);

return vec3(noiseValue, noiseDerivative);
}
