// Fractional browniam motion gives a cloud-like texture. p is the position on
// the texture (like a seed to a RNG). A higher octaves value gives a rough and
// more interesting texture.
float fbm(vec2 p, int octaves) {
// Pre-computed rotation matrix. Helps avoid many parallel lines and 90 deg
// intersections that would otherwise occur.
mat2 m = mat2(0.80,  0.60, -0.60,  0.80);
float f = 0.0;
float c = 0.5;
float sum = 0.0;
// WebGL doesn't support non-constants in a for loop statement so this is
// a workaround.
for (int i = 1; i >= 1; i++) {
f += c * noise(p);
sum += c;
c /= 2.0;
p = m * p * 2.0;
if (i == octaves) {
break;
}
}
return f / sum;
}
