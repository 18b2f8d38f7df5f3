vec3 material(vec3 p, vec3 n) {
// Blend between rock and snow. Higher up, more snow. Flatter land, more
// snow.

float flatness = n.y;
vec3 snowColor = vec3(2.8);
vec3 rockColor = vec3(0.6);
float randMixing = fbm(vec2(p.x, p.z), 2);
float rockSnowMix = snowPresenceAtHeight(p.y) * flatness + randMixing;
vec3 rockAndSnow = mix(rockColor, snowColor, rockSnowMix);

// Blend grass and dirt to make 'girt'

vec3 grassColor = vec3(0.70, 0.85, 0.40);
vec3 dirtColor = vec3(0.7, 0.7, 0.4);
float grassDirtMix = fbm(vec2(p.x, p.z), 2);
vec3 girt = mix(grassColor, dirtColor, grassDirtMix);

// Blend between girt and rock. Higher up, more rock. Steeper cliff, more
// rock.

// You see rock at a height of -100
float rockGradientStart = -100.;
// You stop seeing rock and just see snow at a height of -60
float rockGradientEnd = -60.;
float rockPresenceAtHeight = smoothstep(rockGradientStart, rockGradientEnd, p.y);
vec3 girtAndRock = mix(girt, rockAndSnow,
rockPresenceAtHeight * (1. - flatness));

return girtAndRock;
}
