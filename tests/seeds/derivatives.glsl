float terrain(vec2 p){
vec2 p1 = p * 0.06;
float a = 0.0;
float b = 2.5;
vec2 d = vec2(0.0);
float scl = 2.75;

for(int i = 0; i < 8; i++ ) {
vec3 n = noised(p1);
d += n.yz;
a += b * n.x / (dot(d,d) + 1.0);
b *= -0.4;
a *= .85;
p1 = m * p1 * scl;
}

return a * 3.0;
}
