// importing perlin noise from glsl-noise through glslify
#pragma glslify: cnoise = require(glsl-noise/classic/2d)

#define PI 3.14159265359

mat2 rotate2D(float a) {
float sa = sin(a);
float ca = cos(a);
return mat2(ca, -sa, sa, ca);
}

float fbm(vec2 p) {
float res = 0.0;
float amp = 0.8;
float freq = 1.5;

for(int i = 0; i < 12; i++) {
res += amp * cnoise(p * 0.8);
amp *= 0.5;
freq *= 1.05;
p = p * freq * rotate2D(PI / 4.0);
}
return res;
}

float scene(vec3 p) {
float distance = 0.0;
distance += fbm(p.xz * 0.3);
distance += p.y + 2.0;

return distance;
}
